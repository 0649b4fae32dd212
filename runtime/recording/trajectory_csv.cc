#include "runtime/recording/trajectory_csv.h"

#include <fmt/format.h>

#include "grammar/number.h"

namespace plsc {

std::string TrajectoryCsv(const Trajectory& trajectory) {
  std::string csv = "time,x,y,z,mass_x,mass_y,mass_z,roll,pitch,yaw,contacts";
  for (Eigen::Index j = 0; j < trajectory.joint_angle.rows(); ++j)
    csv += fmt::format(",joint{}", j + 1);
  csv += '\n';
  for (Eigen::Index i = 0; i < trajectory.time.size(); ++i) {
    csv += PrintPlainNumber(trajectory.time[i]);
    for (const auto* columns :
         {&trajectory.core_position, &trajectory.mass_centre,
          &trajectory.core_orientation})
      for (Eigen::Index row = 0; row < 3; ++row)
        csv += "," + PrintPlainNumber((*columns)(row, i));
    csv += fmt::format(",{}", trajectory.contacts[i]);
    for (Eigen::Index j = 0; j < trajectory.joint_angle.rows(); ++j)
      csv += "," + PrintPlainNumber(trajectory.joint_angle(j, i));
    csv += '\n';
  }
  return csv;
}

}  // namespace plsc
