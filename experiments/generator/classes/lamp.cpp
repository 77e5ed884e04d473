#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {

Skeleton lamp() {
  Skeleton s{"lamp", {}};
  const int base = add_limb(s, {.kind = "base", .nodes = {{{0, 0, 0}, 0.5}, {{0, 0, 0.02}, 0.5}}, .flatness = 0.25});
  const int stem = add_limb(s, {.kind = "lower arm",
                                .parent = base,
                                .nodes = {{{0, 0, 0.08}, 0.09}, {{-0.18, 0, 0.45}, 0.06}, {{-0.4, 0, 0.92}, 0.07}},
                                .joints = {{0, {pitch(-18, 35), yaw(-60, 60)}}},
                                .blend = 0.9});
  const int upper =
      add_limb(s, {.kind = "upper arm",
                   .parent = stem,
                   .nodes = {{{-0.4, 0, 0.92}, 0.075}, {{-0.05, 0, 1.22}, 0.058}, {{0.32, 0, 1.52}, 0.065}},
                   .joints = {{0, {pitch(-38, 32)}}}});
  const int shade = add_limb(s, {.kind = "shade",
                                 .parent = upper,
                                 .nodes = {{{0.34, 0, 1.53}, 0.1}, {{0.43, 0, 1.44}, 0.15}, {{0.54, 0, 1.32}, 0.21}},
                                 .joints = {{0, {pitch(-55, 40), roll(-25, 25)}}}});
  add_limb(s, {.kind = "rim",
               .parent = shade,
               .nodes = {{{0.62, 0, 1.24}, 0.36}, {{0.63, 0, 1.23}, 0.36}},
               .blend = 0.6,
               .flat_axis = {0.68, 0, -0.73},
               .flatness = 0.25});
  return s;
}

}  // namespace shapegauge
