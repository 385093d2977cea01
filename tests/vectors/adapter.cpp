// SPDX-License-Identifier: GPL-3.0-or-later
// What an implementer writes to run the conformance vectors, for our own reference:
// corpus/vectors/run.py -- vectors_adapter [MISTAKE]. The mistakes "silent", "garbage", "crash" and "hang"
// are the program's, all others the method's.
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "answers.hpp"

int main(int argc, char** argv) {
  const std::string mistake = argc > 1 ? argv[1] : "";
  std::size_t number = 0;
  for (std::string line; std::getline(std::cin, line); ++number) {
    const auto question = nlohmann::json::parse(line);
    const auto result = tetproof::test::answer(question["kind"], question["input"], mistake);
    if (number == 7 && mistake == "silent") continue;
    if (number == 7 && mistake == "garbage") std::cout << "answer to number 7\n";
    if (number == 7 && mistake == "crash") std::abort();
    if (number == 7 && mistake == "hang") ::sleep(1000);
    if (number % 2 && mistake == "skipping")
      std::cout << nlohmann::json{{"id", question["id"]}, {"skipped", "not implemented"}} << '\n';
    else
      std::cout << nlohmann::json{{"id", question["id"]}, {"result", result}} << '\n';
  }
}
