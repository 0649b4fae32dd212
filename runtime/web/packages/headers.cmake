# Debian's packages that are headers alone, or can be, by their own names in one
# folder: -I/usr/include would bring along those of this machine's C library.
include_guard(GLOBAL)

# plsc_web_headers(TARGET DEFINITION... HEADERS NAME...): an imported target whose
# users see these files and folders of /usr/include.
function(plsc_web_headers target)
  cmake_parse_arguments(ARG "" "" "HEADERS" ${ARGN})
  if(TARGET ${target})
    return()
  endif()
  set(folder ${CMAKE_BINARY_DIR}/packages/include)
  file(MAKE_DIRECTORY ${folder})
  foreach(header IN LISTS ARG_HEADERS)
    if(NOT EXISTS /usr/include/${header})
      message(FATAL_ERROR "there is no /usr/include/${header}; .ci/web installs it")
    endif()
    get_filename_component(name ${header} NAME)
    file(CREATE_LINK /usr/include/${header} ${folder}/${name} SYMBOLIC)
  endforeach()
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE ${folder})
  target_compile_definitions(${target} INTERFACE ${ARG_UNPARSED_ARGUMENTS})
endfunction()
