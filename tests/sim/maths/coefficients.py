#!/usr/bin/env python3
"""Derives the constants of sim/maths from the functions themselves, with 90
digits and more, and compares them with those in the sources given.

A polynomial interpolates its function in the Chebyshev nodes of its interval:
its largest error is within a small factor of the least possible (Muller,
Elementary Functions, 3.2), and nothing is needed but divided differences.

  coefficients.py SOURCE...   exit status 1 tells that a source differs
  coefficients.py --print     the constants, as the sources have them
"""

import re
import sys
from decimal import Decimal, getcontext, localcontext
from fractions import Fraction

getcontext().prec = 90
TERMS = 80  # of every series, which then are exact to all digits
WORDS = 37  # of 2 / pi, of 32 bits each


def series(coefficient, x):
    """sum of coefficient(k) x^k"""
    total, power = Decimal(0), Decimal(1)
    for k in range(TERMS):
        total += coefficient(k) * power
        power *= x
    return total


def factorial(n):
    return Decimal(1) if n < 2 else n * factorial(n - 1)


def arctan_of_inverse(n):
    return sum(Decimal((-1) ** k) / ((2 * k + 1) * Decimal(n) ** (2 * k + 1)) for k in range(270))


with localcontext() as long:
    long.prec = 370
    PI = 16 * arctan_of_inverse(5) - 4 * arctan_of_inverse(239)  # Machin
    TWO_OVER_PI = int(2 / PI * Decimal(2) ** (32 * WORDS))
LN2 = sum(2 / ((2 * k + 1) * Decimal(3) ** (2 * k + 1)) for k in range(100))

# name -> (number of coefficients, interval, coefficients of its power series)
POLYNOMIALS = {
    # (sin(r) / r - 1) / z, z = r^2
    "kSine": (6, 0, (PI / 4) ** 2, lambda k: (-1) ** (k + 1) / factorial(2 * k + 3)),
    # (cos(r) - 1 + z / 2) / z^2, z = r^2
    "kCosine": (6, 0, (PI / 4) ** 2, lambda k: (-1) ** k / factorial(2 * k + 4)),
    # (1 - atan(u) / u) / z, z = u^2
    "kArc": (12, 0, (Decimal(2).sqrt() - 1) ** 2, lambda k: Decimal((-1) ** k) / (2 * k + 3)),
    # (exp(r) - 1 - r) / r^2
    "kExponential": (11, -LN2 / 2, LN2 / 2, lambda k: 1 / factorial(k + 2)),
    # (log((1 + s) / (1 - s)) - 2 s) / (s z), z = s^2
    "kLogarithm": (7, 0, (3 - 2 * Decimal(2).sqrt()) ** 2, lambda k: Decimal(2) / (2 * k + 3)),
}


def cosine(x):
    return series(lambda k: (-1) ** k / factorial(2 * k), x * x)


def interpolant(count, low, high, coefficient):
    """Newton's divided differences, then powers; the constant term first."""
    nodes = [(low + high) / 2 + (high - low) / 2 * cosine((2 * i + 1) * PI / (2 * count))
             for i in range(count)]
    differences = [series(coefficient, x) for x in nodes]
    for level in range(1, count):
        for i in range(count - 1, level - 1, -1):
            differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - level])
    powers = [Decimal(0)] * count
    for i in range(count - 1, -1, -1):  # p = p (x - node_i) + difference_i
        powers = [(powers[k - 1] if k else 0) - nodes[i] * powers[k] for k in range(count)]
        powers[0] += differences[i]
    return powers


def nearest(number):
    """The nearest double."""
    return float(Fraction(number))


def cut(number, bits):
    """The first bits of a number, which is left with the rest."""
    exponent = 0
    while abs(number) < Decimal(2) ** (bits - 1 + exponent):
        exponent -= 1
    return float(Fraction(int(number / Decimal(2) ** exponent)) * Fraction(2) ** exponent)


def parts(number, *bits):
    """A number in pieces of so many bits, the last one the nearest double."""
    pieces = []
    for count in bits:
        pieces.append(cut(number, count))
        number -= Decimal(pieces[-1])
    return pieces + [nearest(number)]


def pair(number):
    value = nearest(number)
    return [value, nearest(number - Decimal(value))]


def constants():
    yield "kHalfPi", parts(PI / 2, 33, 33, 33)
    yield "kQuarterTurn", pair(PI / 2)
    yield "kEighthTurns", [piece for k in range(5) for piece in pair(k * PI / 4)]
    yield "kTanOfSixteenth", [nearest(Decimal(2).sqrt() - 1)]
    yield "kTwoOverPi", [nearest(2 / PI)]
    yield "kLn2", parts(LN2, 32)
    yield "kOneOverLn2", [nearest(1 / LN2)]
    yield "kRootOfTwo", [nearest(Decimal(2).sqrt())]
    yield "kWords", [TWO_OVER_PI >> (32 * (WORDS - 1 - i)) & 0xffffffff for i in range(WORDS)]
    for name, polynomial in POLYNOMIALS.items():
        yield name, [nearest(c) for c in interpolant(*polynomial)]


def text_of(value):
    if value == 0 or isinstance(value, int):
        return f"0x{value:08x}" if value else "0"
    return re.sub(r"\.?0*p", "p", value.hex())


def main():
    if sys.argv[1:] == ["--print"]:
        for name, values in constants():
            print(name, "{" + ", ".join(map(text_of, values)) + "}")
        return 0
    text = "".join(open(name).read() for name in sys.argv[1:])
    failed = 0
    for name, values in constants():
        found = re.search(rf"\b{name}(?:\[\])? = ([^;]*)", text)
        numbers = re.findall(r"-?0x[0-9a-f.]+(?:p[-+]?\d+)?|\b0\b", found[1]) if found else []
        got = [float.fromhex(n) if "p" in n else int(n, 16) for n in numbers]
        if got != values:
            print(f"{name}: {got} is not {values}", file=sys.stderr)
            failed = 1
    return failed


if __name__ == "__main__":
    sys.exit(main())
