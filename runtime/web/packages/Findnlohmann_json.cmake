include(${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
plsc_web_headers(nlohmann_json::nlohmann_json HEADERS nlohmann)
set(nlohmann_json_FOUND TRUE)
