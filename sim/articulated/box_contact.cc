// Two boxes, by separating axes and a clipped face.
//
// Convex bodies are apart exactly if their shadows on some line are, and of two
// boxes 15 lines decide: the sides a_i of one, the sides b_j of the other, and
// the products a_i x b_j of an edge of each (Gottschalk, Lin and Manocha,
// OBBTree, 1996; Ericson, Real-Time Collision Detection, 2005, 4.4). With
// d from centre to centre, C_ij = a_i.b_j and half sides A, B the shadows
// overlap by
//
//   a_i:        A_i + sum_j B_j |C_ij| - |d.a_i|, and b_j likewise,
//   a_i x b_j:  (A_k |C_lj| + A_l |C_kj| + B_m |C_in| + B_n |C_im|
//                - |d.a_l C_kj - d.a_k C_lj|) / s
//
// where i, k, l and j, m, n are turned cyclically and s^2 = C_kj^2 + C_lj^2 is
// the squared sine between the edges. The axis of the least overlap is the
// normal, as the shortest way out of each other is along it.
//
// - Parallel edges give no axis: their product is rounding, and the overlap 0
//   over 0. In the plane across them two rectangles meet, which their sides
//   decide. So pairs with s below kLeastSine are left out. Above it the
//   rounding of d and C, 1e-17 m, moves an overlap by 1e-11 m; what is left out
//   deepens one by s times a side, 1e-7 m.
// - A face is preferred until an edge pair is shallower by kEdgeFactor (ODE's)
//   and kEdgeMargin (our own, as the factor does nothing at a depth of nearly
//   0, where faces slanted by 1e-6 would meet at one point): a face gives a
//   support, an edge pair one point that would come and go with each ripple of
//   nearly equal overlaps. Of faces the first, until another is shallower by
//   more than rounding.
//
// Face: of the other box the face that looks most against the normal, cut by
// the four sides of the first (face_polygon), in the first one's axes with
// depth as third coordinate. Points above are dropped, of the others four kept.
//
// Edges: one point, between the closest points of the two, which are the
// corners farthest along the normal without the edges' own directions.
//
// Invariants: every loop is over a fixed number of axes, sides or points; each
// comparison with an axis is written so that a number that is none parts the
// boxes; only + - * / and sqrt, so that bits are a function of the input.
// Cost: 33 products for C and d and 18 for the faces' overlaps, where 19 of 20
// pairs that are apart end; 8 products for each edge pair, a root, and the
// cuts.

#include "sim/articulated/box_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim/articulated/face_polygon.h"

namespace plsc {
namespace {

constexpr double kEdgeFactor = 1.05;

// m. Small against the depth at which contacts bear a module (micrometres), and
// large against what slants of rounding make of it.
constexpr double kEdgeMargin = 1e-7;

constexpr double kLeastSine = 1e-6;

// The two sides that follow each, cyclically.
constexpr int kNext[] = {1, 2, 0};
constexpr int kAfter[] = {2, 0, 1};

double DotOf(const double (&a)[3], const double (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// How one box lies as the other sees it.
struct BoxView {
  double along[3];      ///< m, from its centre to the other's, by its own sides
  double cosine[3][3];  ///< of own side (first) with the other's
};

/// Both views, and by how much the boxes are apart along each one's sides.
class BoxPair {
 public:
  BoxPair(const OrientedBox& a, const OrientedBox& b) : a_(a), b_(b) {
    double apart[3];
    for (int k = 0; k < 3; ++k) apart[k] = b.centre[k] - a.centre[k];
    for (int i = 0; i < 3; ++i) {
      from_a_.along[i] = DotOf(apart, a.axes[i]);
      from_b_.along[i] = -DotOf(apart, b.axes[i]);
      for (int j = 0; j < 3; ++j) {
        const double cosine = DotOf(a.axes[i], b.axes[j]);
        from_a_.cosine[i][j] = cosine;
        from_b_.cosine[j][i] = cosine;
      }
    }
    for (int i = 0; i < 3; ++i) {
      gaps_a_[i] = GapAlong(i, a, b, from_a_);
      gaps_b_[i] = GapAlong(i, b, a, from_b_);
    }
  }

  const OrientedBox& a() const { return a_; }
  const OrientedBox& b() const { return b_; }
  const BoxView& from_a() const { return from_a_; }
  const BoxView& from_b() const { return from_b_; }
  const double (&gaps_a() const)[3] { return gaps_a_; }
  const double (&gaps_b() const)[3] { return gaps_b_; }

  /// The greatest one.
  double gap() const {
    double most = -std::numeric_limits<double>::infinity();
    for (const double gap : gaps_a_) most = std::max(most, gap);
    for (const double gap : gaps_b_) most = std::max(most, gap);
    return most;
  }
  /// As far as sides tell; by & as branches would be guessed wrong.
  bool AreApart() const {
    return !((gaps_a_[0] <= 0) & (gaps_a_[1] <= 0) & (gaps_a_[2] <= 0) &
             (gaps_b_[0] <= 0) & (gaps_b_[1] <= 0) & (gaps_b_[2] <= 0));
  }

 private:
  static double GapAlong(int i, const OrientedBox& own,
                         const OrientedBox& other, const BoxView& view) {
    const double(&cosine)[3] = view.cosine[i];
    return std::abs(view.along[i]) - own.half[i] -
           (other.half[0] * std::abs(cosine[0]) +
            other.half[1] * std::abs(cosine[1]) +
            other.half[2] * std::abs(cosine[2]));
  }

  const OrientedBox& a_;
  const OrientedBox& b_;
  BoxView from_a_;
  BoxView from_b_;
  double gaps_a_[3];
  double gaps_b_[3];
};

/// The side of the greatest gap, of equals the first.
int GreatestOf(const double (&gaps)[3]) {
  const int first = gaps[1] > gaps[0] ? 1 : 0;
  return gaps[2] > gaps[first] ? 2 : first;
}

/// An edge direction of each box, and how far the shadows on the line across
/// both overlap.
struct EdgeAxis {
  int side_a = -1;     ///< -1 for none
  int side_b = -1;     ///<
  double overlap = 0;  ///< m, times the sine
  double sine2 = 1;    ///< squared sine of the angle between the edges
  double depth() const { return overlap / std::sqrt(sine2); }
};

/// The pair of edges of the least overlap. If a pair parts the boxes, true and
/// that pair with its negative overlap.
bool FindEdges(const BoxPair& pair, EdgeAxis& best) {
  const double(&half_a)[3] = pair.a().half;
  const double(&half_b)[3] = pair.b().half;
  const double(&along)[3] = pair.from_a().along;
  const double(&cosine)[3][3] = pair.from_a().cosine;
  for (int i = 0; i < 3; ++i) {
    const int k = kNext[i], l = kAfter[i];
    for (int j = 0; j < 3; ++j) {
      const int m = kNext[j], n = kAfter[j];
      const double sine2 =
          cosine[k][j] * cosine[k][j] + cosine[l][j] * cosine[l][j];
      if (sine2 < kLeastSine * kLeastSine) continue;
      const double ahead = along[l] * cosine[k][j] - along[k] * cosine[l][j];
      const double overlap = half_a[k] * std::abs(cosine[l][j]) +
                             half_a[l] * std::abs(cosine[k][j]) +
                             half_b[m] * std::abs(cosine[i][n]) +
                             half_b[n] * std::abs(cosine[i][m]) -
                             std::abs(ahead);
      const EdgeAxis edges{i, j, overlap, sine2};
      if (!(overlap >= -kBoxRounding)) {
        best = edges;
        return true;
      }
      // Squares, as the roots would cost more than all else.
      const double positive = std::max(overlap, 0.0);
      if (best.side_a < 0 || positive * positive * best.sine2 <
                                 best.overlap * best.overlap * sine2) {
        best = edges;
        best.overlap = positive;
      }
    }
  }
  return false;
}

int ContactOfEdges(const OrientedBox& a, const OrientedBox& b,
                   const EdgeAxis& edges, BoxContact& contact) {
  const double(&u)[3] = a.axes[edges.side_a];
  const double(&v)[3] = b.axes[edges.side_b];
  const double across[3] = {u[1] * v[2] - u[2] * v[1],
                            u[2] * v[0] - u[0] * v[2],
                            u[0] * v[1] - u[1] * v[0]};
  const double square = DotOf(across, across);
  const double sine = std::sqrt(square);
  // The first box is before the second.
  const double apart[3] = {b.centre[0] - a.centre[0], b.centre[1] - a.centre[1],
                           b.centre[2] - a.centre[2]};
  const double sign = DotOf(apart, across) < 0 ? 1 : -1;
  for (int k = 0; k < 3; ++k) contact.normal[k] = sign * across[k] / sine;
  // The middles of the two edges, and which of four each is.
  double on_a[3], on_b[3];
  std::copy_n(a.centre, 3, on_a);
  std::copy_n(b.centre, 3, on_b);
  int edge_a = 0, edge_b = 0;
  for (int turn = 1; turn <= 2; ++turn) {
    const int i = (edges.side_a + turn) % 3, j = (edges.side_b + turn) % 3;
    const bool is_low_a = DotOf(contact.normal, a.axes[i]) > 0;
    const bool is_low_b = DotOf(contact.normal, b.axes[j]) < 0;
    edge_a = 2 * edge_a + (is_low_a ? 1 : 0);
    edge_b = 2 * edge_b + (is_low_b ? 1 : 0);
    for (int k = 0; k < 3; ++k) {
      on_a[k] += (is_low_a ? -a.half[i] : a.half[i]) * a.axes[i][k];
      on_b[k] += (is_low_b ? -b.half[j] : b.half[j]) * b.axes[j][k];
    }
  }
  // on_a + x u + (along the normal) = on_b + y v: the product with v x across
  // leaves x, that with u x across leaves y. The closest points of the
  // shallowest pair lie on the edges; limits only keep rounding of nearly
  // parallel ones.
  const double w[3] = {on_b[0] - on_a[0], on_b[1] - on_a[1], on_b[2] - on_a[2]};
  const auto determinant = [&](const double(&direction)[3]) {
    return (w[1] * direction[2] - w[2] * direction[1]) * across[0] +
           (w[2] * direction[0] - w[0] * direction[2]) * across[1] +
           (w[0] * direction[1] - w[1] * direction[0]) * across[2];
  };
  const double half_a = a.half[edges.side_a], half_b = b.half[edges.side_b];
  const double x = std::clamp(determinant(v) / square, -half_a, half_a);
  const double y = std::clamp(determinant(u) / square, -half_b, half_b);
  for (int k = 0; k < 3; ++k)
    contact.position[k] = (on_a[k] + x * u[k] + on_b[k] + y * v[k]) / 2;
  contact.depth = edges.depth();
  contact.key = 12 * 6 * 24 +
                ((edges.side_a * 3 + edges.side_b) * 4 + edge_a) * 4 + edge_b;
  return 1;
}

/// A face of one box, and the face of the other that looks most against it.
struct FacePair {
  int side;         ///< the first one's: normal, and two along the face
  int along[2];     ///<
  double sign;      ///< outward is so much times the side
  int cut_side;     ///< the second one's
  double cut_sign;  ///<
};

FacePair FacesOf(const BoxView& view, int side) {
  FacePair faces;
  faces.side = side;
  faces.along[0] = side == 0 ? 1 : 0;
  faces.along[1] = side == 2 ? 1 : 2;
  faces.sign = view.along[side] < 0 ? -1 : 1;
  const double(&cosine)[3] = view.cosine[side];
  faces.cut_side = 0;
  for (int j = 1; j < 3; ++j)
    if (std::abs(cosine[j]) > std::abs(cosine[faces.cut_side]))
      faces.cut_side = j;
  faces.cut_sign = faces.sign * cosine[faces.cut_side] > 0 ? -1 : 1;
  return faces;
}

/// The second box's face in the axes of the first one's.
void PutFaceToCut(const OrientedBox& own, const OrientedBox& other,
                  const BoxView& view, const FacePair& faces,
                  FacePolygon& polygon) {
  const int cut = faces.cut_side;
  const int m = cut == 0 ? 1 : 0, n = cut == 2 ? 1 : 2;
  // Along both sides of the own face, and down from it: the middle of the other
  // face and half its sides.
  const int sides[] = {faces.along[0], faces.along[1], faces.side};
  double middle[3], half_m[3], half_n[3];
  for (int k = 0; k < 3; ++k) {
    const double(&cosine)[3] = view.cosine[sides[k]];
    middle[k] =
        view.along[sides[k]] + faces.cut_sign * other.half[cut] * cosine[cut];
    half_m[k] = other.half[m] * cosine[m];
    half_n[k] = other.half[n] * cosine[n];
  }
  polygon.count = 4;
  for (int corner = 0; corner < 4; ++corner) {
    const double x = corner == 0 || corner == 3 ? 1 : -1;
    const double y = corner < 2 ? 1 : -1;
    double at[3];
    for (int k = 0; k < 3; ++k)
      at[k] = middle[k] + x * half_m[k] + y * half_n[k];
    polygon.points[static_cast<std::size_t>(corner)] = {
        {at[0], at[1]},
        own.half[faces.side] - faces.sign * at[2],
        corner,
        corner};
  }
}

static_assert(kMostSupport == kMostBoxContacts);

/// The face of a box whose side is the normal.
struct Reference {
  bool is_of_a;
  int side;
};

int ContactsOfFace(const BoxPair& pair, const Reference& reference,
                   std::array<BoxContact, kMostBoxContacts>& contacts) {
  const bool is_of_a = reference.is_of_a;
  const OrientedBox& own = is_of_a ? pair.a() : pair.b();
  const OrientedBox& other = is_of_a ? pair.b() : pair.a();
  const BoxView& view = is_of_a ? pair.from_a() : pair.from_b();
  const FacePair faces = FacesOf(view, reference.side);
  FacePolygon polygons[2];
  PutFaceToCut(own, other, view, faces, polygons[0]);
  int latest = 0;
  for (int side = 0; side < 4; ++side)
    if (Cut(polygons[latest], {side, own.half[faces.along[side / 2]]},
            polygons[1 - latest]))
      latest = 1 - latest;
  FacePolygon& polygon = polygons[latest];
  std::size_t below = 0;
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (polygon.points[i].depth >= -kBoxRounding)
      polygon.points[below++] = polygon.points[i];
  polygon.count = below;
  if (below == 0) return 0;
  const std::size_t count = KeepSupport(polygon);
  // The normal leads out of the second box, or into the first.
  const double out = is_of_a ? -faces.sign : faces.sign;
  const int face =
      (is_of_a ? 0 : 6) + 2 * faces.side + (faces.sign < 0 ? 1 : 0);
  const int cut_face = 2 * faces.cut_side + (faces.cut_sign < 0 ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const FacePoint& point = polygon.points[i];
    BoxContact& contact = contacts[i];
    const double height = faces.sign * (own.half[faces.side] - point.depth);
    for (int k = 0; k < 3; ++k) {
      contact.position[k] = own.centre[k] +
                            point.place[0] * own.axes[faces.along[0]][k] +
                            point.place[1] * own.axes[faces.along[1]][k] +
                            height * own.axes[faces.side][k];
      contact.normal[k] = out * own.axes[faces.side][k];
    }
    contact.depth = std::max(point.depth, 0.0);
    contact.key = (face * 6 + cut_face) * 24 + point.feature;
  }
  return static_cast<int>(count);
}

}  // namespace

int CollideBoxes(const OrientedBox& a, const OrientedBox& b,
                 std::array<BoxContact, kMostBoxContacts>& contacts,
                 double& gap) {
  const BoxPair pair(a, b);
  gap = pair.gap();
  if (pair.AreApart()) return 0;
  EdgeAxis edges;
  if (FindEdges(pair, edges)) {
    gap = -edges.depth();
    return 0;
  }
  const int side_a = GreatestOf(pair.gaps_a());
  const int side_b = GreatestOf(pair.gaps_b());
  const double gap_a = pair.gaps_a()[side_a], gap_b = pair.gaps_b()[side_b];
  const bool is_face_of_b = gap_b > gap_a + kBoxRounding;
  const double depth = -(is_face_of_b ? gap_b : gap_a);
  if (edges.side_a >= 0 && kEdgeFactor * edges.depth() + kEdgeMargin < depth)
    return ContactOfEdges(a, b, edges, contacts[0]);
  return ContactsOfFace(pair, {!is_face_of_b, is_face_of_b ? side_b : side_a},
                        contacts);
}

int CollideBoxes(const OrientedBox& a, const OrientedBox& b,
                 std::array<BoxContact, kMostBoxContacts>& contacts) {
  double gap = 0;
  return CollideBoxes(a, b, contacts, gap);
}

double BoxGapBound(const OrientedBox& a, const OrientedBox& b) {
  return BoxPair(a, b).gap();
}

}  // namespace plsc
