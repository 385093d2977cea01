// SPDX-License-Identifier: GPL-3.0-or-later
// The program that writes the files of corpus/bad-meshes. It is run by hand after a kind is added or changed:
// `ninja bad_meshes && ./bad_meshes FOLDER`.
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
