include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
plsc_web_headers(Eigen3::Eigen HEADERS eigen3/Eigen)
set(Eigen3_FOUND TRUE)
