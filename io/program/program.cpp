// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/program.hpp"

#include <Eigen/Core>

#include <fmt/core.h>
#include <tbb/global_control.h>
#include <tbb/version.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <system_error>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/one_line.hpp"
#include "io/error.hpp"
#include "io/program/mesh_formats.hpp"

namespace tetproof::program {
namespace {

std::string version(const std::string& name, const Description& description) {
  std::string text = fmt::format("{} {}\nfmt {}.{}.{}\nEigen {}.{}.{}\noneTBB {}.{}\nCLI11 {}\n", name,
                                 TETPROOF_VERSION, FMT_VERSION / 10000, FMT_VERSION / 100 % 100,
                                 FMT_VERSION % 100, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                 EIGEN_MINOR_VERSION, TBB_VERSION_MAJOR, TBB_VERSION_MINOR, CLI11_VERSION);
  for (const std::string& library : description.libraries) text += library + "\n";
  text.pop_back();
  return text;
}

// Prints examples first, where a reader in a hurry looks. CLI11 has a place for them only at the end.
class ExamplesFirst : public CLI::Formatter {
 public:
  explicit ExamplesFirst(std::string examples) : examples_(std::move(examples)) { column_width(34); }
  std::string make_description(const CLI::App* app) const override {
    return "Examples:\n" + examples_ + "\n" + CLI::Formatter::make_description(app);
  }

 private:
  std::string examples_;
};

constexpr const char* closing =
    "An output that is the same file as an input or as another output is refused.\n"
    "Exit codes: 0 done and nothing is wrong, 1 something is wrong with what was judged, 2 bad input or\n"
    "usage, 3 our own failure, 4 nothing wrong was found, but not everything could be judged.";

// The page or the script that the arguments ask for, if they ask for one. They stand alone, so that no
// argument that a program requires is missed.
std::optional<std::string> asked_page(int argc, char** argv, const CLI::App& app,
                                      const Description& description) {
  const std::string_view first = argc > 1 ? argv[1] : "";
  Choices choices = description.choices;
  choices.try_emplace("FORMAT", format_list());
  if (argc == 2 && first == "--help-man")
    return man_page(app, choices, description.purpose, description.examples, closing, TETPROOF_VERSION);
  if (argc == 3 && first == "--completion") return completion(app, choices, argv[2]);
  return {};
}

// What --help calls the values that are paths begins so.
constexpr std::string_view path_types[] = {"FILE", "GRID", "OTHER.jsonl", "PATH", "DIR"};

// CLI11 breaks long messages.
std::string joined_lines(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

// An unset variable of a script must not turn an asked output into none.
void refuse_empty_paths(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const std::string type = option->get_type_name();
    const bool names_file =
        std::any_of(std::begin(path_types), std::end(path_types),
                    [&](std::string_view known) { return std::string_view(type).starts_with(known); });
    const std::vector<std::string> values = option->results();
    if (names_file && std::find(values.begin(), values.end(), "") != values.end())
      throw InputError(
          fmt::format("{}: expected a value, found '' (see {} --help)", option->get_name(), app.get_name()));
  }
}

}  // namespace

int run(int argc, char** argv, const Description& description,
        const std::function<std::function<int()>(CLI::App&, Common&)>& declare) {
  std::string name = argc > 0 ? argv[0] : "tetproof";
  name = name.substr(name.find_last_of('/') + 1);
  try {
    CLI::App app{description.purpose, name};
    app.formatter(std::make_shared<ExamplesFirst>(description.examples));
    app.footer(closing);
    app.option_defaults()->always_capture_default();
    app.set_version_flag("--version", version(name, description),
                         "print this program's and its libraries' versions");
    Common common;
    const std::function<int()> work = declare(app, common);
    app.add_option("--json", common.json, "write the result as JSON to FILE; - is standard output")
        ->type_name("FILE")
        ->always_capture_default(false);
    app.add_flag("--quiet,-q", common.quiet, "print nothing on standard error except errors");
    app.add_option("--threads", common.threads, "threads to use; 0: all")
        ->type_name("N")
        ->check(CLI::Range(0, 4096));
    if (const std::optional<std::string> page = asked_page(argc, argv, app, description)) {
      write_text("-", *page);
      return sound;
    }
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
      throw InputError(joined_lines(error.what()) + fmt::format(" (see {} --help)", name));
    }
    refuse_empty_paths(app);
    const std::size_t threads =
        common.threads > 0 ? static_cast<std::size_t>(common.threads)
                           : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return work();
  } catch (const InputError& error) {
    fmt::print(stderr, "{}: {}\n", name, io::in_one_line(error.what()));
    return bad_input;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "{}: out of memory\n", name);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: internal error, please report it with the command and the input: {}\n", name,
               io::in_one_line(error.what()));
  }
  return own_failure;
}

void say(const Common& common, const std::string& line) {
  if (common.quiet) return;
  if (common.progress) common.progress->hide();
  fmt::print(stderr, "{}\n", io::in_one_line(line));
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
      throw InputError(fmt::format("standard output: cannot write: {}", std::strerror(errno)));
    return;
  }
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void write_json(const std::string& path, const nlohmann::ordered_json& json) {
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  write_text(path, io::escape_controls_of_json(text) + "\n");
}

}  // namespace tetproof::program
