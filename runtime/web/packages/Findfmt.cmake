# And what rooms include without a find_package: fast_float where the standard
# library does not read doubles (grammar/number.cc), Random123 (runtime/vary).
include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
plsc_web_headers(fmt::fmt FMT_HEADER_ONLY HEADERS fmt fast_float Random123)
set(fmt_FOUND TRUE)
