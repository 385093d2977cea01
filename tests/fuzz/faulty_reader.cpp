// SPDX-License-Identifier: GPL-3.0-or-later
// A reader of .msh 2.2 with planted bugs, for tetproof-fuzz --reader: it crashes on a negative count, waits
// for an end marker that never comes, and takes the memory that a count asks for. "none" has no bug. usage:
// tetproof-faulty-reader BUG FILE    BUG: none, negative, endless, greedy
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

[[gnu::noinline]] void crash_on_negative_count() {
  std::abort();
}

[[gnu::noinline]] void wait_for_the_end() {
  for (volatile bool waits = true; waits;) {
  }
}

[[gnu::noinline]] void take_all(long long count) {
  std::vector<std::vector<char>> all;
  for (long long k = 0; k < count; k += 1000000) {
    all.emplace_back(1000000);
    std::memset(all.back().data(), 1, all.back().size());
  }
}

int refuse(const char* why) {
  std::cerr << "error: " << why << "\n";
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return refuse("usage: tetproof-faulty-reader BUG FILE");
  const std::string bug = argv[1];
  std::ifstream file(argv[2]);
  std::string line;
  if (!std::getline(file, line) || line != "$MeshFormat") return refuse("no mesh");
  while (std::getline(file, line) && line != "$Nodes") {
  }
  std::getline(file, line);
  char* end = nullptr;
  const long long count = std::strtoll(line.c_str(), &end, 10);
  if (end == line.c_str()) return refuse("no count");
  if (count < 0) {
    if (bug == "negative") crash_on_negative_count();
    return refuse("a negative count");
  }
  if (bug == "greedy")
    take_all(count);
  else if (count > 1000000)
    return refuse("too many nodes");
  while (std::getline(file, line) && line != "$EndNodes") {
  }
  if (line != "$EndNodes") {
    if (bug == "endless") wait_for_the_end();
    return refuse("no $EndNodes");
  }
}
