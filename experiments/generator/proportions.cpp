#include "shapegauge/experiments/generator/proportions.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace shapegauge {

namespace {

constexpr double largest_deviation = 0.07;

struct Growth {
  double length = 1;
  double girth = 1;
};

std::map<std::string, Growth> draw_growth(const Skeleton& skeleton, RandomNumbers& random) {
  std::map<std::string, Growth> growth;
  for (const Limb& limb : skeleton.limbs) {
    const auto [position, is_new] = growth.try_emplace(limb.kind);
    if (!is_new) continue;
    position->second.length = random.uniform(1 - largest_deviation, 1 + largest_deviation);
    position->second.girth = random.uniform(1 - largest_deviation, 1 + largest_deviation);
  }
  return growth;
}

// Where every bone's surroundings go: stretched along the bone and around it, moved along with the bone's parent.
std::vector<Eigen::Affine3d> bone_maps(const Skeleton& skeleton, const BoneTree& tree, RandomNumbers& random) {
  const std::map<std::string, Growth> growth = draw_growth(skeleton, random);
  std::vector<Eigen::Affine3d> maps;
  for (const Bone& bone : tree.bones) {
    const Growth& factors = growth.at(skeleton.limbs[static_cast<std::size_t>(bone.limb)].kind);
    const Eigen::Vector3d start =
        bone.parent < 0 ? bone.joint : maps[static_cast<std::size_t>(bone.parent)] * bone.joint;
    const Eigen::Matrix3d along = bone.direction * bone.direction.transpose();
    const Eigen::Matrix3d stretch = factors.length * along + factors.girth * (Eigen::Matrix3d::Identity() - along);
    maps.emplace_back(Eigen::Translation3d(start) * stretch * Eigen::Translation3d(-bone.joint));
  }
  return maps;
}

}  // namespace

RestPose draw_individual(const Skeleton& skeleton, const RestPose& rest, const Eigen::MatrixXd& weights,
                         RandomNumbers& random) {
  const std::vector<Eigen::Affine3d> maps = bone_maps(skeleton, rest.tree, random);
  RestPose result = rest;
  result.points.setZero();
  for (std::size_t b = 0; b < maps.size(); ++b) {
    const Points moved = (rest.points * maps[b].linear().transpose()).rowwise() + maps[b].translation().transpose();
    result.points += weights.col(static_cast<Eigen::Index>(b)).asDiagonal() * moved;
    result.tree.bones[b].joint = maps[b] * rest.tree.bones[b].joint;
  }
  return result;
}

}  // namespace shapegauge
