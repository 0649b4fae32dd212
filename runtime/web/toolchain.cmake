# Debian's emscripten, and for find_package the headers and sources of packages/:
# the libraries that Debian has built are of another processor.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/packages)

# Exceptions as the page's machine has them; emscripten's own way calls
# JavaScript around each call.
set(CMAKE_CXX_FLAGS_INIT -fwasm-exceptions)
