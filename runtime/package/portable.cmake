# The tarball: plsc with every library that it is linked with, the C library and
# its loader among them, for machines with other ones
# (docs/decisions/0018-the-tarball-brings-its-loader.md).
#
#   bin/plsc          starts lib/plsc/plsc by the loader that lies beside it
#   lib/plsc/         program, loader, libraries
#   share/            as in the Debian package; licenses of the libraries

# The objects of plsc but for two, which would look for libraries of the machine
# that do not fit to the C library brought along. A program's own objects come
# before those of libraries that define the same.
add_executable(plsc_portable
  ${PROJECT_SOURCE_DIR}/runtime/cli/main.cc
  ${PROJECT_SOURCE_DIR}/runtime/cli/files/no_png.cc
  ${PROJECT_SOURCE_DIR}/runtime/workers/no_mpi_link.cc)
target_link_libraries(plsc_portable PRIVATE plsc_cli)
target_link_options(plsc_portable PRIVATE -Wl,--as-needed)
set_target_properties(plsc_portable PROPERTIES
  OUTPUT_NAME plsc
  RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/portable
  INSTALL_RPATH_USE_LINK_PATH OFF)

install(TARGETS plsc_portable DESTINATION lib/plsc
  COMPONENT portable EXCLUDE_FROM_ALL)
install(PROGRAMS launcher.sh DESTINATION bin RENAME plsc
  COMPONENT portable EXCLUDE_FROM_ALL)
install(CODE "
  set(program $<TARGET_FILE:plsc_portable>)
  set(documents ${CMAKE_INSTALL_DOCDIR})"
  COMPONENT portable EXCLUDE_FROM_ALL)
install(SCRIPT ${CMAKE_CURRENT_SOURCE_DIR}/bundle_libraries.cmake
  COMPONENT portable EXCLUDE_FROM_ALL)
