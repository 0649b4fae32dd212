include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
plsc_web_headers(taocpp::pegtl HEADERS tao)
set(pegtl_FOUND TRUE)
