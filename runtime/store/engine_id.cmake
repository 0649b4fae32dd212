# cmake -DOUTPUT=FILE.cc -DLIBRARIES=FILE,... -P engine_id.cmake: writes the source
# of EngineId (engine.h), a hash of the libraries' contents. Not of their names or
# times, so that a build repeated is the same engine.
string(REPLACE "," ";" LIBRARIES "${LIBRARIES}")
set(hashes "")
foreach(library IN LISTS LIBRARIES)
  file(SHA256 ${library} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 id "${hashes}")
string(SUBSTRING ${id} 0 32 id)
file(WRITE ${OUTPUT} "#include \"runtime/store/engine.h\"

namespace plsc {

std::string_view EngineId() {
  return \"${id}\";
}

}  // namespace plsc
")
