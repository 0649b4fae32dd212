# Run by `cmake --install --component portable`: copies the shared libraries that
# `program` needs, and their licenses into `documents`, and lists the packages
# that they are of, whose sources Debian keeps.
set(prefix "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
file(GET_RUNTIME_DEPENDENCIES
  EXECUTABLES ${program}
  RESOLVED_DEPENDENCIES_VAR libraries
  CONFLICTING_DEPENDENCIES_PREFIX conflicting)
find_program(dpkg_query dpkg-query)
set(packages)
file(MAKE_DIRECTORY ${prefix}/lib/plsc ${prefix}/${documents}/licenses)
foreach(library IN LISTS libraries)
  get_filename_component(name ${library} NAME)
  message(STATUS "Bundling: ${library}")
  # By the name that it is asked for; a link's target has a longer one.
  file(COPY_FILE ${library} ${prefix}/lib/plsc/${name})
  if(dpkg_query)
    # Folders below / may be links to those below /usr.
    get_filename_component(file ${library} REALPATH)
    string(REGEX REPLACE "^/usr" "" file ${file})
    execute_process(COMMAND ${dpkg_query} -S "*${file}"
      OUTPUT_VARIABLE owner ERROR_QUIET)
    if(owner MATCHES "^([^:, ]+)")
      list(APPEND packages ${CMAKE_MATCH_1})
    endif()
  endif()
endforeach()

list(REMOVE_DUPLICATES packages)
list(SORT packages)
set(text "The libraries in lib/plsc are those of these Debian packages. Their licenses
are in licenses; their sources are kept at https://snapshot.debian.org.

")
foreach(package IN LISTS packages)
  execute_process(COMMAND ${dpkg_query} -W
      -f "\${binary:Package} \${Version} (source: \${source:Package} \${source:Version})\n"
      ${package}
    OUTPUT_VARIABLE line)
  string(APPEND text "${line}")
  file(COPY_FILE /usr/share/doc/${package}/copyright
    ${prefix}/${documents}/licenses/${package}.txt)
endforeach()
if(packages)
  file(WRITE ${prefix}/${documents}/libraries.txt "${text}")
  # What Debian's copyright files refer to.
  file(COPY /usr/share/common-licenses/ FOLLOW_SYMLINK_CHAIN
    DESTINATION ${prefix}/${documents}/licenses/common)
endif()
