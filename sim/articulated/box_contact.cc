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
// - A face is preferred until an edge pair is shallower by kEdgeFactor (ODE's):
//   a face gives a support, an edge pair one point that would come and go with
//   each ripple of nearly equal overlaps. Of faces the first, until another is
//   shallower by more than rounding.
//
// Face: of the other box the face that looks most against the normal is cut by
// the four sides of the first (Sutherland and Hodgman 1974), in the first one's
// axes, depth as third coordinate; points above are dropped. A corner that is
// out of a side by rounding is in, so that aligned boxes meet at corners and
// not at crossings that rounding makes. Of more than four points these are
// kept: the deepest, the farthest from it, the one of the largest triangle and
// the one farthest outside of that (as sim/ground does), of equals the first.
// ODE chooses by angles about the centroid.
//
// Edges: one point, between the closest points of the two, which are the
// corners farthest along the normal without the edges' own directions.
//
// Invariants: every loop is over a fixed number of axes, sides or points; each
// comparison with an axis is written so that a number that is none parts the
// boxes; only + - * / and sqrt, so that bits are a function of the input.
// Cost: 27 products for C and 18 for the faces' overlaps, where most pairs
// that are apart end; 9 products for each edge pair.

#include "sim/articulated/box_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace plsc {
namespace {

// m. More than sums of lengths below 1 m lose, less than any depth of concern.
constexpr double kBoxRounding = 1e-12;

constexpr double kEdgeFactor = 1.05;

constexpr double kLeastSine = 1e-6;

// m2. As sim/ground: a support of less is none.
constexpr double kLeastSupport = 1e-9;

double DotOf(const double (&a)[3], const double (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// How one box lies as the other sees it.
struct BoxView {
  double along[3];      ///< m, from its centre to the other's, by its own sides
  double cosine[3][3];  ///< of own side (first) with the other's
};

struct FaceAxis {
  double gap = -std::numeric_limits<double>::infinity();  ///< m
  int side = 0;
};

/// Both views, and by how much the boxes are apart along each box's sides.
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
    are_apart_ =
        !(FindFace(a, b, from_a_, face_a_) && FindFace(b, a, from_b_, face_b_));
  }

  const OrientedBox& a() const { return a_; }
  const OrientedBox& b() const { return b_; }
  const BoxView& from_a() const { return from_a_; }
  const BoxView& from_b() const { return from_b_; }
  const FaceAxis& face_a() const { return face_a_; }
  const FaceAxis& face_b() const { return face_b_; }
  /// As far as faces tell.
  bool are_apart() const { return are_apart_; }
  double gap() const { return std::max(face_a_.gap, face_b_.gap); }

 private:
  /// The side of the greatest gap, and whether all overlap.
  static bool FindFace(const OrientedBox& own, const OrientedBox& other,
                       const BoxView& view, FaceAxis& face) {
    bool all_overlap = true;
    for (int i = 0; i < 3; ++i) {
      const double(&cosine)[3] = view.cosine[i];
      const double gap = std::abs(view.along[i]) - own.half[i] -
                         (other.half[0] * std::abs(cosine[0]) +
                          other.half[1] * std::abs(cosine[1]) +
                          other.half[2] * std::abs(cosine[2]));
      if (!(gap <= 0)) all_overlap = false;
      if (gap > face.gap) face = {gap, i};
    }
    return all_overlap;
  }

  const OrientedBox& a_;
  const OrientedBox& b_;
  BoxView from_a_;
  BoxView from_b_;
  FaceAxis face_a_;
  FaceAxis face_b_;
  bool are_apart_;
};

/// An edge direction of each box, and how far the shadows on the line across
/// both overlap.
struct EdgeAxis {
  int side_a = -1;        ///< -1 for none
  int side_b = -1;        ///<
  double overlap = 0;     ///< m, times the sine
  double sine2 = 1;       ///< squared sine of the angle between the edges
  bool is_ahead = false;  ///< the second box lies along a_i x b_j
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
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int m = (j + 1) % 3, n = (j + 2) % 3;
      const double sine2 =
          cosine[k][j] * cosine[k][j] + cosine[l][j] * cosine[l][j];
      if (sine2 < kLeastSine * kLeastSine) continue;
      const double ahead = along[l] * cosine[k][j] - along[k] * cosine[l][j];
      const double overlap = half_a[k] * std::abs(cosine[l][j]) +
                             half_a[l] * std::abs(cosine[k][j]) +
                             half_b[m] * std::abs(cosine[i][n]) +
                             half_b[n] * std::abs(cosine[i][m]) -
                             std::abs(ahead);
      const EdgeAxis edges{i, j, overlap, sine2, ahead >= 0};
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
  const double sign = edges.is_ahead ? -1 : 1;
  for (int k = 0; k < 3; ++k)
    contact.normal[k] = sign * across[k] / std::sqrt(square);
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

/// A corner of the cut face, in the axes of the face that it lies on.
struct FacePoint {
  double place[2];   ///< m, from the middle of the face
  double depth = 0;  ///< m
  /// What it is: 0 to 3 a corner of the cut face; 4 + 4 e + s where its edge e
  /// crosses side s; 20 to 23 a corner of the cutting face.
  int feature = 0;
  int edge = 0;  ///< what leads to the next point: 0 to 3, or 4 + side
};

/// A cut of a convex polygon makes one corner more, of four corners eight. If
/// rounding bends an edge, so that a line leaves and enters n corners n/2
/// times, it is at most 4, 6, 9, 13, 19.
struct FacePolygon {
  std::array<FacePoint, 20> points;
  std::size_t count = 0;

  void Add(const FacePoint& point) { points[count++] = point; }
};

/// Sides 0 and 1 are the high and the low one of the first coordinate, 2 and 3
/// of the second.
struct CuttingSide {
  int number;
  double half;  ///< m

  /// How far a point is outside.
  double Beyond(const FacePoint& point) const {
    const double place = point.place[number / 2];
    return (number % 2 == 0 ? place : -place) - half;
  }
};

/// Where the way from a point inside to one outside crosses the side. `edge`
/// is the way.
FacePoint CrossingOf(const FacePoint& inside, const FacePoint& outside,
                     const CuttingSide& side, int edge) {
  const double from = side.Beyond(inside), to = side.Beyond(outside);
  const double part = from / (from - to);
  FacePoint point;
  for (int k = 0; k < 2; ++k)
    point.place[k] =
        inside.place[k] + part * (outside.place[k] - inside.place[k]);
  point.place[side.number / 2] = side.number % 2 == 0 ? side.half : -side.half;
  point.depth = inside.depth + part * (outside.depth - inside.depth);
  // An earlier side is one of the first coordinate, as parallel sides meet not.
  point.feature = edge < 4 ? 4 + 4 * edge + side.number
                           : 20 + 2 * ((edge - 4) % 2) + side.number % 2;
  return point;
}

/// Leaves what lies within the side.
void Cut(FacePolygon& polygon, const CuttingSide& side) {
  bool is_cut = false;
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (side.Beyond(polygon.points[i]) > kBoxRounding) is_cut = true;
  if (!is_cut) return;
  FacePolygon rest;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const FacePoint& from = polygon.points[i];
    const FacePoint& to = polygon.points[i + 1 < polygon.count ? i + 1 : 0];
    const bool is_in = side.Beyond(from) <= kBoxRounding;
    const bool ends_in = side.Beyond(to) <= kBoxRounding;
    if (is_in) rest.Add(from);
    // A point on the side is itself the crossing.
    if (is_in && !ends_in) {
      if (side.Beyond(from) < -kBoxRounding)
        rest.Add(CrossingOf(from, to, side, from.edge));
      rest.points[rest.count - 1].edge = 4 + side.number;
    } else if (!is_in && ends_in && side.Beyond(to) < -kBoxRounding) {
      rest.Add(CrossingOf(to, from, side, from.edge));
      rest.points[rest.count - 1].edge = from.edge;
    }
  }
  polygon = rest;
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
FacePolygon FaceToCut(const OrientedBox& own, const OrientedBox& other,
                      const BoxView& view, const FacePair& faces) {
  const int m = faces.cut_side == 0 ? 1 : 0, n = faces.cut_side == 2 ? 1 : 2;
  // Middle and half sides of the face along own side i.
  const auto middle = [&](int i) {
    return view.along[i] + faces.cut_sign * other.half[faces.cut_side] *
                               view.cosine[i][faces.cut_side];
  };
  const auto half_m = [&](int i) { return other.half[m] * view.cosine[i][m]; };
  const auto half_n = [&](int i) { return other.half[n] * view.cosine[i][n]; };
  FacePolygon polygon;
  polygon.count = 4;
  for (int corner = 0; corner < 4; ++corner) {
    FacePoint& point = polygon.points[static_cast<std::size_t>(corner)];
    const double x = corner == 0 || corner == 3 ? 1 : -1;
    const double y = corner < 2 ? 1 : -1;
    const auto at = [&](int i) {
      return middle(i) + x * half_m(i) + y * half_n(i);
    };
    for (int k = 0; k < 2; ++k) point.place[k] = at(faces.along[k]);
    point.depth = own.half[faces.side] - faces.sign * at(faces.side);
    point.feature = corner;
    point.edge = corner;
  }
  return polygon;
}

/// Twice the area of a triangle, negative if it runs clockwise.
double AreaOf(const FacePoint& a, const FacePoint& b, const FacePoint& c) {
  return (b.place[0] - a.place[0]) * (c.place[1] - a.place[1]) -
         (b.place[1] - a.place[1]) * (c.place[0] - a.place[0]);
}

/// The point of the greatest score; a later one only if it is greater by more
/// than `rounding`, so that a choice between equals stays from step to step.
template <typename Score>
std::size_t FirstBest(const FacePolygon& polygon, double rounding,
                      const Score& score) {
  std::size_t best = 0;
  double greatest = score(polygon.points[0]);
  for (std::size_t i = 1; i < polygon.count; ++i) {
    const double value = score(polygon.points[i]);
    if (value <= greatest + rounding) continue;
    best = i;
    greatest = value;
  }
  return best;
}

/// Puts the points that are handed on first; how many these are.
std::size_t Support(FacePolygon& polygon) {
  std::array<FacePoint, 20>& points = polygon.points;
  const std::size_t deepest = FirstBest(
      polygon, kBoxRounding, [](const FacePoint& p) { return p.depth; });
  if (polygon.count <= kMostBoxContacts) {
    std::swap(points[0], points[deepest]);
    return polygon.count;
  }
  const FacePoint a = points[deepest];
  const FacePoint b =
      points[FirstBest(polygon, kBoxRounding, [&](const FacePoint& p) {
        const double x = p.place[0] - a.place[0], y = p.place[1] - a.place[1];
        return x * x + y * y;
      })];
  const FacePoint c =
      points[FirstBest(polygon, kBoxRounding, [&](const FacePoint& p) {
        return std::abs(AreaOf(a, b, p));
      })];
  const double area = AreaOf(a, b, c);
  // How far a point lies outside of the triangle, as the area it would add.
  const auto added = [&](const FacePoint& p) {
    const double side = area > 0 ? 1 : -1;
    return -std::min({side * AreaOf(a, b, p), side * AreaOf(b, c, p),
                      side * AreaOf(c, a, p)});
  };
  const FacePoint d = points[FirstBest(polygon, kBoxRounding, added)];
  points[0] = a;
  points[1] = b;
  if (std::abs(area) < kLeastSupport) return 2;
  points[2] = c;
  if (added(d) < kLeastSupport) return 3;
  points[3] = d;
  return 4;
}

/// `first` is 1 if `own` is the first box of the pair, -1 if the second.
int ContactsOfFace(const OrientedBox& own, const OrientedBox& other,
                   const BoxView& view, const FacePair& faces, int first,
                   std::array<BoxContact, kMostBoxContacts>& contacts) {
  FacePolygon polygon = FaceToCut(own, other, view, faces);
  for (int side = 0; side < 4; ++side)
    Cut(polygon, {side, own.half[faces.along[side / 2]]});
  std::size_t below = 0;
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (polygon.points[i].depth >= -kBoxRounding)
      polygon.points[below++] = polygon.points[i];
  polygon.count = below;
  if (below == 0) return 0;
  const std::size_t count = Support(polygon);
  const int face =
      (first > 0 ? 0 : 6) + 2 * faces.side + (faces.sign < 0 ? 1 : 0);
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
      contact.normal[k] = -first * faces.sign * own.axes[faces.side][k];
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
  if (pair.are_apart()) return 0;
  EdgeAxis edges;
  if (FindEdges(pair, edges)) {
    gap = -edges.depth();
    return 0;
  }
  const FaceAxis& face_a = pair.face_a();
  const FaceAxis& face_b = pair.face_b();
  const bool is_face_of_b = face_b.gap > face_a.gap + kBoxRounding;
  const double depth = -(is_face_of_b ? face_b : face_a).gap;
  if (edges.side_a >= 0 && kEdgeFactor * edges.depth() + kBoxRounding < depth)
    return ContactOfEdges(a, b, edges, contacts[0]);
  if (is_face_of_b)
    return ContactsOfFace(b, a, pair.from_b(),
                          FacesOf(pair.from_b(), face_b.side), -1, contacts);
  return ContactsOfFace(a, b, pair.from_a(),
                        FacesOf(pair.from_a(), face_a.side), 1, contacts);
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
