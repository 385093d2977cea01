// SPDX-License-Identifier: GPL-3.0-or-later
// A C++ function as a mesher.
#include <time.h>

#include <chrono>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "corpus/meshing/mesher.hpp"
#include "corpus/meshing/output_lines.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {

namespace {

double thread_cpu() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class FunctionMesher : public Mesher {
 public:
  FunctionMesher(MeshFunction function, std::string name)
      : function_(std::move(function)), name_(std::move(name)) {}

  MesherRun run(const TriangleSurface& surface, const std::string& folder, const Limits&) const override {
    MesherRun run;
    const auto begin = std::chrono::steady_clock::now();
    const double cpu = thread_cpu();
    const auto fail = [&run](Outcome outcome, std::string message) {
      run.failure = outcome;
      run.signature = without_numbers(message);
      run.message = run.output = std::move(message);
    };
    try {
      run.mesh = function_(surface);
      if (run.mesh.tets.empty()) fail(Outcome::no_tetrahedra, "no tetrahedra");
    } catch (const std::bad_alloc&) {
      fail(Outcome::out_of_memory, "std::bad_alloc");
    } catch (const std::exception& reason) {
      fail(Outcome::refused, reason.what());
    } catch (...) {
      fail(Outcome::refused, "threw something that is no std::exception");
    }
    run.cpu_s = thread_cpu() - cpu;
    run.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (run.failure) return run;
    auto document = std::make_shared<Document>(document_of(run.mesh));
    run.numbering = numbering(*document);
    if (!folder.empty()) {
      run.mesh_file = folder + "/mesh.msh";
      write_document(run.mesh_file, *document, {.format = "msh41", .binary = true});
    }
    run.document = std::move(document);
    return run;
  }

  std::string name() const override { return name_; }
  std::string command() const override { return name_ + "({surface})"; }
  std::string version() const override { return ""; }
  std::string surface_ending() const override { return ""; }
  bool may_change_boundary() const override { return false; }
  double fidelity() const override { return 0; }
  int repeats() const override { return 1; }

 private:
  MeshFunction function_;
  std::string name_;
};

}  // namespace

std::unique_ptr<Mesher> function_mesher(MeshFunction function, std::string name) {
  return std::make_unique<FunctionMesher>(std::move(function), std::move(name));
}

}  // namespace tetproof::corpus
