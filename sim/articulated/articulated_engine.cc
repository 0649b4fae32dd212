#include "sim/engine.h"
namespace plsc {
std::unique_ptr<Engine> MakeArticulatedEngine(const Scene& scene) {
  return MakeOdeEngine(scene);
}
}  // namespace plsc
