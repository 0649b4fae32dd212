# Compiled from Debian's sources, which .ci/web fetches.
if(NOT TARGET yaml-cpp)
  set(PLSC_YAML_CPP ${CMAKE_BINARY_DIR}/packages/yaml-cpp
    CACHE PATH "The sources of yaml-cpp 0.7")
  file(GLOB sources CONFIGURE_DEPENDS ${PLSC_YAML_CPP}/src/*.cpp)
  if(NOT sources)
    message(FATAL_ERROR
      "there are no sources of yaml-cpp in ${PLSC_YAML_CPP}; .ci/web fetches them")
  endif()
  add_library(yaml-cpp STATIC ${sources})
  target_include_directories(yaml-cpp SYSTEM PUBLIC ${PLSC_YAML_CPP}/include)
  target_compile_definitions(yaml-cpp PUBLIC YAML_CPP_STATIC_DEFINE)
  # Its sources have names of one namespace in common.
  set_target_properties(yaml-cpp PROPERTIES UNITY_BUILD OFF)
endif()
set(yaml-cpp_FOUND TRUE)
