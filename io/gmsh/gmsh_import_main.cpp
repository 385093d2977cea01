// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-gmsh-import: reads a file with the Gmsh SDK and writes its mesh as binary .msh 4.1, for
// io/gmsh/gmsh_import.cpp. Like Gmsh it says lines that begin with "Error   : " or "Warning : ". A line
// "Dropped : COUNT, ITEM, EXAMPLE" is about a part of Gmsh's model that is no mesh.
#include <fcntl.h>
#include <gmsh.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace {

void say(const char* kind, const std::string& text) {
  std::printf("%-8s: %s\n", kind, text.c_str());
}

void drop(std::size_t count, const std::string& item, const std::string& example) {
  say("Dropped", std::to_string(count) + ", " + item + ", " + example);
}

// Names may hold anything, a line end too.
std::string name_of_view(int tag) {
  std::string name;
  gmsh::option::getString("View[" + std::to_string(gmsh::view::getIndex(tag)) + "].Name", name);
  std::replace(name.begin(), name.end(), '\n', ' ');
  return name;
}

bool has_errors() {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  return std::any_of(log.begin(), log.end(),
                     [](const std::string& line) { return line.starts_with("Error"); });
}

struct Holdings {
  std::size_t geometry = 0;      // entities that could be meshed
  std::string last;              // the last of them, of the highest dimension
  bool geometry_meshed = false;  // some of them are meshed: a script decided what it wants
  bool elements = false;
};

Holdings holdings() {
  Holdings all;
  std::vector<std::pair<int, int>> entities;
  gmsh::model::getEntities(entities);
  for (const auto& [dim, tag] : entities) {
    std::string type;
    gmsh::model::getType(dim, tag, type);
    std::vector<int> elements;
    gmsh::model::mesh::getElementTypes(elements, dim, tag);
    all.elements |= !elements.empty();
    if (type.starts_with("Discrete") || type.starts_with("Partition") || type.starts_with("Ghost")) continue;
    ++all.geometry;
    all.last = type + " of dimension " + std::to_string(dim) + " and tag " + std::to_string(tag);
    all.geometry_meshed |= !elements.empty();
  }
  return all;
}

// gmsh::write takes only names that end in .msh. `Save` in a script takes any, so also that of an open file
// without a name.
void write_mesh(int out) {
  gmsh::option::setNumber("Mesh.Format", 1);
  gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
  gmsh::option::setNumber("Mesh.Binary", 1);
  gmsh::option::setNumber("Mesh.SaveAll", 1);
  gmsh::option::setNumber("Mesh.PartitionSplitMeshFiles", 0);
  const std::string script = "Save \"/proc/self/fd/" + std::to_string(out) + "\";\n";
  const int memory = ::memfd_create("save", MFD_CLOEXEC);
  if (memory < 0 || ::write(memory, script.data(), script.size()) != static_cast<ssize_t>(script.size()))
    throw std::string("no memory for a script");
  gmsh::merge("/proc/self/fd/" + std::to_string(memory));
}

// Gmsh can be built without support for some formats. It says so itself, except for this one, which it then
// reads as a script.
bool built_for(const std::string& in) {
  const std::string ending = in.substr(std::min(in.rfind('.'), in.size()));
  std::string options;
  gmsh::option::getString("General.BuildOptions", options);
  if ((ending != ".cgns" && ending != ".CGNS") || options.find("Cgns") != options.npos) return true;
  say("Error", "this Gmsh was built without CGNS");
  return false;
}

bool import(const char* in, int out) {
  if (!built_for(in)) return false;
  gmsh::open(in);
  if (has_errors()) return false;
  Holdings found = holdings();
  std::vector<int> views;
  gmsh::view::getTags(views);
  if (found.geometry > 0 && !found.geometry_meshed) {
    gmsh::model::mesh::generate(3);
    if (has_errors()) return false;
    found = holdings();
    std::string version;
    gmsh::option::getString("General.Version", version);
    if (found.elements)
      say("Warning", "the file holds geometry, and its mesh is Gmsh " + version + "'s, with default sizes");
  }
  if (!found.elements) {
    say("Error", "finds no mesh and no geometry in it" +
                     (views.empty() ? "" : ", but " + std::to_string(views.size()) + " views of values"));
    return false;
  }
  write_mesh(out);
  if (found.geometry > 0) drop(found.geometry, "geometry of entities", found.last);
  if (!views.empty()) drop(views.size(), "views of values", name_of_view(views[0]));
  return !has_errors();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::fprintf(stderr,
                 "usage: tetproof-gmsh-import IN OUT.msh [PARENT]\n"
                 "Writes what the Gmsh SDK reads from IN as binary .msh 4.1, for the tetproof programs.\n"
                 "Ends together with its parent process if the parent's number is given.\n");
    return 2;
  }
  if (argc == 4) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != std::atoi(argv[3])) return 2;  // the parent has ended already
  }
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int out = ::open(argv[2], O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (out < 0) {
    std::perror(argv[2]);
    return 2;
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  gmsh::initialize(0, nullptr, false);  // without the user's settings
  gmsh::option::setNumber("General.Terminal", 1);
  gmsh::option::setNumber("General.Verbosity", 2);  // errors and warnings
  gmsh::logger::start();
  bool done = false;
  try {
    done = import(argv[1], out);
  } catch (const std::string& error) {  // Gmsh's own error, which it has usually said already
    if (!has_errors()) say("Error", error);
  } catch (const std::exception& error) {
    say("Error", error.what());
  } catch (...) {
    say("Error", "an unknown exception");
  }
  std::fflush(nullptr);
  std::_Exit(done ? 0 : 2);  // all is written; the end of Gmsh and its libraries takes time, and may crash
}
