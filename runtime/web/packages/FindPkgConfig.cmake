# Of what the core rooms ask pkg-config for, xxHash is the only one here.
include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
plsc_web_headers(PkgConfig::XXHASH XXH_INLINE_ALL HEADERS xxhash.h)
function(pkg_check_modules prefix)
  if(NOT prefix STREQUAL "XXHASH")
    message(FATAL_ERROR "a page's module has no ${prefix}")
  endif()
endfunction()
set(PkgConfig_FOUND TRUE)
