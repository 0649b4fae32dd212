#pragma once

// Sine and cosine, of the same bits on every machine. All arguments, in rad,
// are reduced exactly, also those of millions of turns: the error is below 0.9
// units in the last place everywhere. Not a number of infinities and of what is
// none.

namespace plsc {

struct SineCosine {
  double sine = 0;
  double cosine = 1;
};

double Sin(double x);
double Cos(double x);
/// Both for the price of one and a half.
SineCosine SinCos(double x);

}  // namespace plsc
