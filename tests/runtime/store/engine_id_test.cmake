# cmake -DSCRIPT=engine_id.cmake -DFOLDER=FOLDER -P engine_id_test.cmake: equal
# libraries are the same engine wherever they lie and whenever they were built,
# and a byte makes another one.
function(id result)
  list(JOIN ARGN "," libraries)
  execute_process(COMMAND ${CMAKE_COMMAND} -DOUTPUT=${FOLDER}/id.cc
    -DLIBRARIES=${libraries} -P ${SCRIPT} COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${FOLDER}/id.cc text)
  if(NOT text MATCHES "return \"([0-9a-f]+)\";")
    message(FATAL_ERROR "no id in: ${text}")
  endif()
  set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()
foreach(file IN ITEMS a/one b/one)
  file(WRITE ${FOLDER}/${file} "this")
  file(WRITE ${FOLDER}/${file}.two "that")
endforeach()
id(here ${FOLDER}/a/one ${FOLDER}/a/one.two)
id(there ${FOLDER}/b/one ${FOLDER}/b/one.two)
file(WRITE ${FOLDER}/b/one.two "thaT")
id(other ${FOLDER}/b/one ${FOLDER}/b/one.two)
if(NOT here STREQUAL there OR here STREQUAL other)
  message(FATAL_ERROR "${here} ${there} ${other}")
endif()
