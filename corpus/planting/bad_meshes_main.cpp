// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the files of corpus/bad-meshes. By hand, when kinds were added: `ninja bad_meshes && ./bad_meshes
// FOLDER`.
#include <iostream>

#include "corpus/bad_meshes.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: bad_meshes FOLDER\n";
    return 2;
  }
  const auto meshes = tetproof::corpus::bad_meshes();
  tetproof::corpus::write_bad_meshes(argv[1], meshes);
  std::cout << meshes.size() << " meshes\n";
}
