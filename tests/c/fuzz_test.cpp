// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of the C interface with damaged arguments: each returns a known status, and a result or none, and
// prints nothing. Run it under AddressSanitizer, too (preset asan).
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "tests/c/handles.hpp"
#include "tests/support/meshes.hpp"

namespace tetproof::test {
namespace {

class Fuzz {
 public:
  explicit Fuzz(unsigned seed) : random_(seed) {}

  bool rarely() { return below(6) == 0; }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  template <class T, std::size_t N>
  T one_of(const T (&all)[N]) {
    return all[random_() % N];
  }
  // One of twenty, since an array has many places to damage.
  template <class T>
  void damage(T& value, std::initializer_list<T> others) {
    if (below(20) == 0) value = others.begin()[random_() % others.size()];
  }
  // Null, rarely.
  template <class T>
  T* given(T* pointer) {
    return below(12) == 0 ? nullptr : pointer;
  }

  void damage_count(std::int64_t& count) {
    damage<std::int64_t>(
        count, {0, 1, count / 2, -1, most, least, std::int64_t{1} << 31, (std::int64_t{1} << 32) + 1});
  }
  void damage_stride(std::int64_t& stride) {
    damage<std::int64_t>(stride, {most, least, most - 7, most / 3, least / 5, std::int64_t{1} << 62});
  }
  std::int32_t truth() { return rarely() ? one_of<std::int32_t>({-1, 2, 77, 2147483647}) : below(2); }
  double odd_number(double usual) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return rarely() ? one_of<double>({NAN, infinity, -infinity, -1, 0, 1e308, 5e-324, -0.0}) : usual;
  }
  std::size_t size(std::size_t own) {
    return rarely() ? one_of<std::size_t>({0, 1, own - 1, own + 1, own + 8, SIZE_MAX, own / 2}) : own;
  }
  // A text with any bytes but zero.
  std::string text(std::string usual) {
    if (rarely()) return one_of<const char*>({"", ",", "-", "\xff\xfe", "../..", "a,b", "\n", "none:"});
    if (below(12) == 0) return std::string(100'000, 'x');
    if (rarely() && !usual.empty())
      usual[static_cast<std::size_t>(below(static_cast<int>(usual.size())))] =
          static_cast<char>(1 + below(255));
    return usual;
  }

  static constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  static constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();

 private:
  std::mt19937 random_;
};

// Arrays of a mesh whose numbers are damaged; there is room for each at 64 bits.
struct DamagedArrays : Arrays {
  std::vector<std::int64_t> tags;
  tetproof_integers groups{};

  explicit DamagedArrays(Fuzz& fuzz) : Arrays(lattice_mesh({2, 1, 1}), 1), tags(12) {
    for (double& x : xyz)
      if (fuzz.below(60) == 0) x = fuzz.odd_number(x * 2);
    for (std::int64_t& corner : corners)
      if (fuzz.below(30) == 0)
        corner = fuzz.one_of<std::int64_t>({0, -1, 13, 1, Fuzz::most, Fuzz::least, std::int64_t{1} << 31});
    for (std::int64_t& tag : tags)
      tag =
          fuzz.rarely() ? fuzz.one_of<std::int64_t>({-1, Fuzz::most, std::int64_t{1} << 31}) : fuzz.below(3);
    groups = {tags.data(), 12, 0, 0, 0, 64};
    fuzz.damage_count(points.count), fuzz.damage_count(tets.count), fuzz.damage_count(groups.count);
    fuzz.damage_stride(points.stride), fuzz.damage_stride(tets.stride), fuzz.damage_stride(groups.stride);
    fuzz.damage_stride(points.component_stride), fuzz.damage_stride(tets.component_stride);
    fuzz.damage<std::int32_t>(tets.bits, {0, 16, 32, 33, -64});
    fuzz.damage<std::int32_t>(groups.bits, {0, 8, 32, 65});
    fuzz.damage<std::int64_t>(tets.base, {0, -5, Fuzz::most, Fuzz::least, std::int64_t{1} << 62});
    fuzz.damage<std::int64_t>(groups.base, {1, Fuzz::least});
    fuzz.damage<const void*>(points.data, {nullptr});
    fuzz.damage<const void*>(tets.data, {nullptr});
  }
};

// A call's status is known, its error says the same, and it made something only if it succeeded.
template <class Object, class Call>
std::unique_ptr<Object, Free> expect_sane(Fuzz& fuzz, std::array<int, 8>& seen, const Call& call) {
  Object* object = nullptr;
  tetproof_error error;
  std::memset(&error, 0x5A, sizeof error);
  tetproof_error* const to = fuzz.given(&error);
  Object** const out = fuzz.given(&object);
  const tetproof_status status = call(out, to);
  EXPECT_GE(status, TETPROOF_OK);
  EXPECT_LE(status, TETPROOF_OUT_OF_TIME) << error.message;  // memory suffices, and there is no fault of ours
  if (status < 0 || status >= 8) return nullptr;
  ++seen[static_cast<std::size_t>(status)];
  EXPECT_TRUE(status == TETPROOF_OK || object == nullptr);
  if (to) {
    EXPECT_EQ(error.status, status);
    EXPECT_NE(std::memchr(error.message, 0, sizeof error.message), nullptr);
    EXPECT_EQ(std::strchr(error.message, '\n'), nullptr) << error.message;
    EXPECT_EQ(error.message[0] == 0, status == TETPROOF_OK);
  }
  return std::unique_ptr<Object, Free>(object);
}

tetproof_judge_options damaged_judge_options(Fuzz& fuzz, std::string (&texts)[4]) {
  tetproof_judge_options options = judge_options();
  options.size = fuzz.size(sizeof options);
  options.region = fuzz.one_of<std::int32_t>({0, 0, 0, 1, 2, 3, 4, -1});
  options.voxels = fuzz.one_of<std::int32_t>({0, 0, 8, 9, -1, 1025});
  options.fidelity = fuzz.odd_number(0.1);
  options.deadline = fuzz.rarely() ? fuzz.odd_number(1e-7) : 0;
  options.threads = fuzz.one_of<std::int32_t>({0, 1, 2, 3, 4096, 5000, -1});
  for (std::int32_t* flag : {&options.strict_topology, &options.coarse, &options.decide_only,
                             &options.only_tets, &options.quality, &options.timings})
    if (fuzz.rarely()) *flag = fuzz.truth();
  texts[0] = fuzz.text("inverted,flat,overlap"), texts[1] = fuzz.text("normals");
  texts[2] = fuzz.text("crack"), texts[3] = fuzz.text("physical");
  if (fuzz.rarely()) options.check = texts[0].c_str();
  if (fuzz.rarely()) options.skip = texts[1].c_str();
  if (fuzz.rarely()) options.allow = texts[2].c_str();
  if (fuzz.rarely()) options.region_kind = texts[3].c_str();
  return options;
}

tetproof_mesh_options damaged_mesh_options(Fuzz& fuzz) {
  tetproof_mesh_options options = mesh_options();
  options.size = fuzz.size(sizeof options);
  fuzz.damage<std::int32_t>(options.region, {0, 1, 3, -9});
  for (std::int32_t& cells : options.cells)
    cells = fuzz.rarely() ? fuzz.one_of<std::int32_t>({0, -1, 2147483647, 1}) : 4;
  options.points = fuzz.one_of<std::int64_t>({0, 2, 5, -2, Fuzz::least});
  for (double* number : {&options.box_scale, &options.on_surface, &options.v0, &options.v1, &options.e_avg,
                         &options.p, &options.improve_below})
    if (fuzz.rarely()) *number = fuzz.odd_number(*number);
  for (std::int32_t* flag : {&options.diagonals, &options.literal, &options.parametric,
                             &options.v0_is_absolute, &options.curvature, &options.past_dilution})
    if (fuzz.rarely()) *flag = fuzz.truth();
  fuzz.damage<std::int32_t>(options.improve, {1, 2, 3, -1});
  return options;
}

void expect_each(const std::array<int, 8>& seen, std::initializer_list<tetproof_status> statuses) {
  for (const tetproof_status status : statuses)
    EXPECT_GT(seen[static_cast<std::size_t>(status)], 10) << tetproof_status_name(status);
}

TEST(CFuzz, JudgesDamagedArrays) {
  std::array<int, 8> seen{};
  const Surface ball = opened("octahedron");
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Fuzz fuzz(seed);
    const DamagedArrays arrays(fuzz);
    std::string texts[4];
    const tetproof_judge_options options = damaged_judge_options(fuzz, texts);
    const Report report = expect_sane<tetproof_report>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_judge(fuzz.given(&arrays.points), fuzz.given(&arrays.tets),
                            fuzz.rarely() ? &arrays.groups : nullptr, fuzz.rarely() ? ball.get() : nullptr,
                            fuzz.rarely() ? &options : nullptr, out, error);
    });
    if (!report) continue;
    EXPECT_EQ(json_of(report)[0], '{');
    EXPECT_NE(tetproof_report_records(report.get())->check_count, 0);
    expect_sane<tetproof_document>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_report_defects(report.get(), fuzz.given(&arrays.points), fuzz.given(&arrays.tets), out,
                                     error);
    });
    expect_sane<char>(fuzz, seen, [&](char** out, auto* error) {
      return tetproof_report_junit(report.get(), fuzz.text("mesh").c_str(), out, error);
    });
    if (seed % 10 == 0)  // a page is a megabyte
      expect_sane<char>(fuzz, seen, [&](char** out, auto* error) {
        return tetproof_report_html(report.get(), fuzz.given(&arrays.points), fuzz.given(&arrays.tets),
                                    fuzz.rarely() ? ball.get() : nullptr, fuzz.text("mesh").c_str(), out,
                                    error);
      });
  }
  expect_each(seen, {TETPROOF_OK, TETPROOF_BAD_ARGUMENT, TETPROOF_TOO_LARGE});
}

TEST(CFuzz, MakesDocumentsAndSurfacesOfDamagedArrays) {
  std::array<int, 8> seen{};
  for (unsigned seed = 0; seed < 1500; ++seed) {
    SCOPED_TRACE(seed);
    Fuzz fuzz(seed);
    const DamagedArrays arrays(fuzz), others(fuzz);
    tetproof_integers triangles = others.tets;
    triangles.base = fuzz.rarely() ? triangles.base : arrays.tets.base;
    const FileDocument document = expect_sane<tetproof_document>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_document_from_arrays(
          fuzz.given(&arrays.points), fuzz.given(&arrays.tets), fuzz.rarely() ? &arrays.groups : nullptr,
          fuzz.rarely() ? &triangles : nullptr, fuzz.rarely() ? &others.groups : nullptr, out, error);
    });
    Surface surface = expect_sane<tetproof_surface>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_surface_from_arrays(fuzz.given(&arrays.points), fuzz.given(&triangles), out, error);
    });
    if (document) {
      const std::string name = fuzz.text("steel");
      expect_sane<char>(fuzz, seen, [&](char** out, auto* error) {
        tetproof_document_name_group(document.get(), fuzz.below(6) - 1, fuzz.below(4), name.c_str(), nullptr);
        return tetproof_document_json(document.get(), out, error);
      });
      tetproof_write_options options{fuzz.size(sizeof options), nullptr, fuzz.below(4) - 1,
                                     fuzz.below(5) - 1};
      const std::string format = fuzz.text("msh22");
      if (fuzz.rarely()) options.format = format.c_str();
      expect_sane<char>(fuzz, seen, [&](char** out, auto* error) {
        return tetproof_document_losses(document.get(), fuzz.text("a.vtu").c_str(), &options, out, error);
      });
      const tetproof_document_arrays* view = nullptr;
      EXPECT_EQ(tetproof_document_view(document.get(), &view, nullptr), TETPROOF_OK);
      expect_sane<tetproof_report>(fuzz, seen, [&](auto** out, auto* error) {
        return tetproof_judge_document(document.get(), nullptr, nullptr, out, error);
      });
      if (!surface)
        surface = expect_sane<tetproof_surface>(fuzz, seen, [&](auto** out, auto* error) {
          return tetproof_surface_from_document(document.get(), out, error);
        });
    }
    if (!surface) continue;
    expect_sane<char>(fuzz, seen, [&](char** out, auto* error) {
      return tetproof_surface_fault(surface.get(), out, error);
    });
  }
  expect_each(seen, {TETPROOF_OK, TETPROOF_BAD_ARGUMENT, TETPROOF_BAD_INPUT, TETPROOF_TOO_LARGE});
}

TEST(CFuzz, ReadsAndMeshesWithDamagedArguments) {
  std::array<int, 8> seen{};
  const std::string off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Fuzz fuzz(seed);
    const std::string bytes = fuzz.text(off), format = fuzz.text("off"), spec = fuzz.text("octahedron");
    const FileDocument document = expect_sane<tetproof_document>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_document_read_memory(fuzz.given(bytes.data()), bytes.size(),
                                           fuzz.rarely() ? format.c_str() : nullptr, out, error);
    });
    expect_sane<tetproof_document>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_document_read(fuzz.given(bytes.c_str()), format.c_str(), out, error);
    });
    const Surface surface = expect_sane<tetproof_surface>(fuzz, seen, [&](auto** out, auto* error) {
      return document ? tetproof_surface_from_document(fuzz.given(document.get()), out, error)
                      : tetproof_surface_open(fuzz.given(spec.c_str()), nullptr, out, error);
    });
    const tetproof_mesh_options options = damaged_mesh_options(fuzz);
    expect_sane<tetproof_document>(fuzz, seen, [&](auto** out, auto* error) {
      return tetproof_mesh(surface.get(), fuzz.given(&options), out, error);
    });
  }
  expect_each(seen, {TETPROOF_OK, TETPROOF_BAD_ARGUMENT, TETPROOF_BAD_INPUT});
}

}  // namespace
}  // namespace tetproof::test
