#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "tests/sim/articulated/random_boxes.h"

// box_contact_copy.cc, compiled with -O0 and with -O3.
namespace plsc_O0 {
std::uint64_t HashOfContacts(const std::vector<double>& numbers);
}
namespace plsc_O3 {
std::uint64_t HashOfContacts(const std::vector<double>& numbers);
}

namespace plsc {
namespace {

void Append(const OrientedBox& box, std::vector<double>& numbers) {
  for (const double x : box.centre) numbers.push_back(x);
  for (const auto& axis : box.axes)
    for (const double x : axis) numbers.push_back(x);
  for (const double x : box.half) numbers.push_back(x);
}

TEST_CASE("Contacts have the same bits however they are compiled",
          "[box_contact]") {
  std::vector<double> numbers;
  test::RandomBoxes random(22);
  for (int i = 0; i < 10000; ++i) {
    test::BoxPose pose = random.Next();
    // Centres drawn here, as where boxes begin to touch is found in long
    // double, which machines have of different lengths.
    for (int k = 0; k < 3; ++k)
      pose.second.centre[k] =
          pose.first.centre[k] + random.Uniform(-0.04, 0.04);
    Append(pose.first, numbers);
    Append(pose.second, numbers);
  }
  // The same on all machines.
  constexpr std::uint64_t kFiled = 0xe1db752d72b6dff4U;
  CHECK(plsc_O0::HashOfContacts(numbers) == kFiled);
  CHECK(plsc_O3::HashOfContacts(numbers) == kFiled);
}

}  // namespace
}  // namespace plsc
