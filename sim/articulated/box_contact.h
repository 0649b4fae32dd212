#pragma once

// Where two boxes touch: a normal, and up to four points with their depths
// and with keys by which a step finds again what it knew of them. Plain
// numbers: the same bits from every compiler on every machine.

#include <array>

namespace plsc {

struct OrientedBox {
  double centre[3];  ///< m
  /// axes[i] is the unit direction of side i: the columns of a rotation, one
  /// after the other, as Eigen's matrices lie in memory.
  double axes[3][3];
  double half[3];  ///< m, half the length of each side
};

/// Signs are ODE's: moving the first box by depth along the normal, or the
/// second as far against it, would part them at this point.
struct BoxContact {
  double position[3];  ///< m
  double normal[3];    ///< unit, from the second box towards the first
  double depth = 0;    ///< m, at least 0
  /// Which features of the boxes meet here: from 0 to kBoxContactKeys - 1,
  /// different for all contacts of a pair, and the same from step to step while
  /// these features touch.
  int key = 0;
};

/// Contacts of one pair.
inline constexpr int kMostBoxContacts = 4;

inline constexpr int kBoxContactKeys = 12 * 6 * 24 + 9 * 4 * 4;

/// The number of contacts, the deepest first; 0 if the boxes are apart, or if a
/// number in them is none (NaN). `gap`: if they are apart, metres that they are
/// apart at least, and else at most 0.
int CollideBoxes(const OrientedBox& a, const OrientedBox& b,
                 std::array<BoxContact, kMostBoxContacts>& contacts,
                 double& gap);
int CollideBoxes(const OrientedBox& a, const OrientedBox& b,
                 std::array<BoxContact, kMostBoxContacts>& contacts);

/// Metres that the boxes are apart at least, seen along the sides of both; not
/// positive if that does not tell. What moved no point by as much needs not be
/// looked at again.
double BoxGapBound(const OrientedBox& a, const OrientedBox& b);

}  // namespace plsc
