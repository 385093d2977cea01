// SPDX-License-Identifier: GPL-3.0-or-later
// What the sources of the Python extension share: arrays, surfaces that are judged once, and work without
// Python's lock.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <array>
#include <cfenv>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/document.hpp"
#include "io/surface_files.hpp"
#include "io/tet_mesh.hpp"
#include "verify/surface.hpp"

namespace tetproof::python {

namespace py = pybind11;

/// A surface with its name for messages. It is judged when that is first asked for, and only once.
class Surface {
 public:
  Surface(SurfaceFile file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}
  const SurfaceFile& file() const { return file_; }
  const TriangleSurface& surface() const { return file_.surface; }
  const std::string& name() const { return name_; }
  /// Any number of threads may ask.
  const verify::JudgedSurface& judged() const {
    std::call_once(once_, [&] { judged_.emplace(file_.surface, file_.numbering); });
    return *judged_;
  }

 private:
  SurfaceFile file_;
  std::string name_;
  mutable std::once_flag once_;
  mutable std::optional<verify::JudgedSurface> judged_;
};

/// The calling thread's arena of so many threads (0, and more than there are: all; oneTBB prints a warning if
/// it is asked for more). It is kept, since oneTBB 2021.8 loses 7 KB with each arena that ends.
inline tbb::task_arena& arena_of(int threads) {
  thread_local std::map<int, tbb::task_arena> arenas;
  const std::size_t all = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  if (threads > 0 && static_cast<std::size_t>(threads) >= all) threads = 0;
  return arenas.try_emplace(threads, threads > 0 ? threads : static_cast<int>(tbb::task_arena::automatic))
      .first->second;
}

/// Runs `work` without Python's lock, on `threads` threads (0: all), and with the processor's usual
/// arithmetic: another library may have changed the rounding or switched off denormal numbers in this
/// process, and the verdict must not depend on that. The arena's threads have the arithmetic of its first
/// use.
template <class Work>
auto run(int threads, const Work& work) {
  struct PlainArithmetic {
    std::fenv_t saved{};
    PlainArithmetic() {
      std::fegetenv(&saved);
      std::fesetenv(FE_DFL_ENV);
    }
    ~PlainArithmetic() { std::fesetenv(&saved); }
  };
  const py::gil_scoped_release unlocked;
  const PlainArithmetic plain;
  return arena_of(threads).execute(work);
}

/// A text, which may hold bytes of files that are no UTF-8: these are replaced.
inline py::str text(const std::string& bytes) {
  return py::bytes(bytes).attr("decode")("utf-8", "replace");
}
inline py::list text(const std::vector<std::string>& all) {
  py::list texts;
  for (const std::string& bytes : all) texts.append(text(bytes));
  return texts;
}

/// A table of numbers that `owner` keeps alive, not copied and not to be written to.
template <class T>
py::array view(const T* numbers, std::vector<py::ssize_t> shape, const py::handle& owner) {
  py::array_t<T> array(std::move(shape), numbers, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}
inline py::array view(const std::vector<Eigen::Vector3d>& points, const py::handle& owner) {
  return view(points.empty() ? nullptr : points[0].data(), {static_cast<py::ssize_t>(points.size()), 3},
              owner);
}
template <std::size_t N>
py::array view(const std::vector<std::array<Index, N>>& rows, const py::handle& owner) {
  return view(rows.empty() ? nullptr : rows[0].data(), {static_cast<py::ssize_t>(rows.size()), N}, owner);
}

/// A table that owns these rows, and may be written to.
template <class Row, class Number>
py::array own(std::vector<Row>&& rows) {
  constexpr auto each = static_cast<py::ssize_t>(sizeof(Row) / sizeof(Number));
  auto* kept = new std::vector<Row>(std::move(rows));
  const py::capsule owner(kept, [](void* rows_kept) { delete static_cast<std::vector<Row>*>(rows_kept); });
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(kept->size())};
  if constexpr (each > 1) shape.push_back(each);
  return py::array_t<Number>(std::move(shape), reinterpret_cast<const Number*>(kept->data()), owner);
}
inline py::tuple own(TetMesh&& mesh) {
  return py::make_tuple(own<Eigen::Vector3d, double>(std::move(mesh.points)),
                        own<std::array<Index, 4>, Index>(std::move(mesh.tets)));
}

/// Rows of N indices from a table of int32 or int64 in C's order. An index that no point has becomes -1-k,
/// where `unknown[k]` is that number.
template <std::size_t N>
std::vector<std::array<Index, N>> rows_of(const py::array& table, std::size_t points,
                                          std::vector<std::int64_t>& unknown);
extern template std::vector<std::array<Index, 3>> rows_of<3>(const py::array&, std::size_t,
                                                             std::vector<std::int64_t>&);
extern template std::vector<std::array<Index, 4>> rows_of<4>(const py::array&, std::size_t,
                                                             std::vector<std::int64_t>&);
/// Points from a table of n x 3 doubles in C's order.
std::vector<Eigen::Vector3d> points_of(const py::array_t<double>& table);

void bind_documents(py::module_& module);
void bind_judge(py::module_& module);
void bind_surfaces(py::module_& module);

}  // namespace tetproof::python
