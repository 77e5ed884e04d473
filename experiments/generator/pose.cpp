#include "shapegauge/experiments/generator/pose.h"

#include <cstddef>

namespace shapegauge {

namespace {

// The bend of a limb that curls: for each of its hinges a number in [-1, 1] at the limb's root and one at its tip.
struct Curl {
  std::vector<double> at_root, at_tip;
};

double angle_within(const Hinge& hinge, double fraction, double amplitude) {
  return amplitude * (0.5 * (hinge.lower + hinge.upper) + 0.5 * fraction * (hinge.upper - hinge.lower));
}

std::vector<int> bone_counts(const BoneTree& tree) {
  std::vector<int> counts(tree.bone_of_segment.size());
  for (const Bone& bone : tree.bones) ++counts[static_cast<std::size_t>(bone.limb)];
  return counts;
}

// A number in [-1, 1] for one hinge of a bone: independent of the others, or nearly that of the limb's smooth bend.
double draw_fraction(bool curls, Curl& curl, std::size_t hinge, double position, RandomNumbers& random) {
  if (!curls) return random.uniform(-1, 1);
  while (curl.at_root.size() <= hinge) {
    curl.at_root.push_back(random.uniform(-1, 1));
    curl.at_tip.push_back(random.uniform(-1, 1));
  }
  const double common = (1 - position) * curl.at_root[hinge] + position * curl.at_tip[hinge];
  return 0.85 * common + 0.15 * random.uniform(-1, 1);
}

}  // namespace

std::vector<RigidMotion> draw_pose(const Skeleton& skeleton, const BoneTree& tree, double amplitude,
                                   RandomNumbers& random) {
  const std::vector<int> counts = bone_counts(tree);
  std::vector<Curl> curls(skeleton.limbs.size());
  std::vector<RigidMotion> motions;
  for (const Bone& bone : tree.bones) {
    const auto limb = static_cast<std::size_t>(bone.limb);
    const double position = static_cast<double>(bone.place) / std::max(1, counts[limb] - 1);
    RigidMotion motion = bone.parent < 0 ? RigidMotion() : motions[static_cast<std::size_t>(bone.parent)];
    const Eigen::Vector3d joint = motion.rotation * bone.joint + motion.translation;
    for (std::size_t h = 0; h < bone.hinges.size(); ++h) {
      const double fraction = draw_fraction(skeleton.limbs[limb].curls, curls[limb], h, position, random);
      const double angle = angle_within(bone.hinges[h], fraction, amplitude);
      motion.rotation = motion.rotation * Eigen::AngleAxisd(angle, bone.hinges[h].axis);
    }
    motion.translation = joint - motion.rotation * bone.joint;
    motions.push_back(motion);
  }
  return motions;
}

Points skinned(const Points& points, const Eigen::MatrixXd& weights, const std::vector<RigidMotion>& motions) {
  // The dual part of a motion's quaternion is half of translation times rotation.
  const auto bones = static_cast<Eigen::Index>(motions.size());
  Eigen::Matrix<double, Eigen::Dynamic, 8> motion_rows(bones, 8);
  for (Eigen::Index b = 0; b < bones; ++b) {
    const RigidMotion& motion = motions[static_cast<std::size_t>(b)];
    const Eigen::Vector3d half = 0.5 * motion.translation;
    const Eigen::Quaterniond dual = Eigen::Quaterniond(0, half.x(), half.y(), half.z()) * motion.rotation;
    motion_rows.row(b) << motion.rotation.coeffs().transpose(), dual.coeffs().transpose();
  }
  // A motion and its negative are the same; those of a parent and its child are on the same side as they are made.
  const Eigen::Matrix<double, Eigen::Dynamic, 8> blended = weights * motion_rows;
  Points result(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double norm = blended.row(i).head<4>().norm();
    const Eigen::Quaterniond real(Eigen::Vector4d(blended.row(i).head<4>().transpose() / norm));
    const Eigen::Quaterniond dual(Eigen::Vector4d(blended.row(i).tail<4>().transpose() / norm));
    const Eigen::Vector3d translation = 2 * (dual * real.conjugate()).vec();
    const Eigen::Vector3d point = points.row(i);
    result.row(i) = (real * point + translation).transpose();
  }
  return result;
}

}  // namespace shapegauge
