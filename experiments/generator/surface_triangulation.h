#pragma once

// Of CGAL: to be included by sources only.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Robust_circumcenter_traits_3.h>
#include <CGAL/Surface_mesh_cell_base_3.h>
#include <CGAL/Surface_mesh_vertex_base_3.h>
#include <cstddef>

namespace shapegauge {

/// A vertex or cell that knows when it was made. CGAL then orders handles by that and not by address, without which the
/// refinement of a surface would not be the same from run to run.
template <typename Base>
class TimeStamped : public Base {
 public:
  using Base::Base;
  using Has_timestamp = CGAL::Tag_true;

  template <typename DataStructure>
  struct Rebind_TDS {
    using Other = TimeStamped<typename Base::template Rebind_TDS<DataStructure>::Other>;
  };

  std::size_t time_stamp() const { return time_stamp_; }
  void set_time_stamp(const std::size_t& time_stamp) { time_stamp_ = time_stamp; }

 private:
  std::size_t time_stamp_ = static_cast<std::size_t>(-1);  // CGAL's sign for "none yet"
};

/// CGAL's default triangulation for surface meshes, with time stamps.
using SurfaceTriangulationTraits =
    CGAL::Robust_circumcenter_traits_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using SurfaceTriangulation = CGAL::Delaunay_triangulation_3<
    SurfaceTriangulationTraits,
    CGAL::Triangulation_data_structure_3<
        TimeStamped<CGAL::Surface_mesh_vertex_base_3<SurfaceTriangulationTraits>>,
        TimeStamped<CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<
            SurfaceTriangulationTraits, CGAL::Surface_mesh_cell_base_3<SurfaceTriangulationTraits>>>>>;

}  // namespace shapegauge
