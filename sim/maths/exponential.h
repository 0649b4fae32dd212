#pragma once

// Exponential and natural logarithm, of the same bits on every machine; within
// 0.9 units in the last place. Zeros, infinities, subnormal numbers and what is
// no number as C's functions have them.

namespace plsc {

double Exp(double x);
double Log(double x);

}  // namespace plsc
