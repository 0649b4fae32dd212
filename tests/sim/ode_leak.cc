// For programs whose simulations end by ODE's own assertions: such a step loses
// 80 bytes of ODE's own (sim/ode keeps the rest in reach); all other leaks
// are told.

// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" const char* __lsan_default_suppressions() {
  return "leak:PreallocateJobInfos";
}
