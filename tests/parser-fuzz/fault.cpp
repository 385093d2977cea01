// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault.hpp"

#include <algorithm>
#include <exception>

#include "allocation_peak.hpp"
#include "io/error.hpp"

namespace tetproof::test {
namespace {

constexpr std::size_t memory_floor = std::size_t{64} << 20;

// A file and those beside it, which its reader may take as well.
std::size_t size_with_companions(const std::filesystem::path& file) {
  std::size_t size = 0;
  for (const auto& there : std::filesystem::directory_iterator(file.parent_path()))
    if (there.is_regular_file() && there.path().stem().stem() == file.stem().stem())
      size += there.file_size();
  return size;
}

}  // namespace

std::string fault(const std::function<void(const std::string&)>& read, const std::filesystem::path& file) {
  const std::size_t size = size_with_companions(file), before = allocated();
  std::string wrong;
  start_peak();
  try {
    read(file.string());
  } catch (const InputError& error) {
    const std::string message = error.what();
    if (message.empty() ||
        std::any_of(message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 127; }))
      wrong = "the message is not one line of text: " + message;
  } catch (const std::exception& error) {
    wrong = std::string("an exception that is no InputError: ") + error.what();
  }
  const std::size_t most = memory_floor + 10 * size, used = peak_allocated() - before;
  if (used > most) wrong = std::to_string(used) + " bytes of memory for files of " + std::to_string(size);
  return wrong;
}

}  // namespace tetproof::test
