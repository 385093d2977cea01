// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/medit/medit_solution_write.hpp"

#include <fmt/format.h>

#include <bit>
#include <limits>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/text_output.hpp"
#include "io/medit/medit_keywords.hpp"
#include "io/medit/medit_solution.hpp"

namespace tetproof::io {
namespace {

std::vector<double> numbers_of(const MeditFields& fields, std::size_t item) {
  std::vector<double> numbers;
  for (const auto& [values, field] : fields) add_medit_numbers(*values, field, item, numbers);
  return numbers;
}

}  // namespace

std::size_t medit_row(const MeditFields& fields) {
  std::size_t row = 0;
  for (const auto& [values, field] : fields) row += static_cast<std::size_t>(medit_numbers(field, 3));
  return row;
}

void write_medit_numbers(AtomicFile& file, const MeditFields& fields, std::size_t items, bool binary) {
  const std::size_t longest = medit_row(fields) * (binary ? sizeof(double) : longest_real + 1);
  write_items(file, items, longest, [&](std::size_t i, char* to) {
    for (const double number : numbers_of(fields, i))
      to = binary ? store(to, number, std::endian::native) : put(put(to, number), ' ');
    if (!binary) to[-1] = '\n';
    return to;
  });
}

namespace {

void write_text(AtomicFile& file, const MeditFields& fields, std::size_t nodes) {
  file.write(
      fmt::format("MeshVersionFormatted 2\n\nDimension 3\n\nSolAtVertices\n{}\n{}", nodes, fields.size()));
  for (const auto& [values, field] : fields) file.write(fmt::format(" {}", field));
  file.write("\n");
  write_medit_numbers(file, fields, nodes, false);
  file.write("\nEnd\n");
}

void write_binary(AtomicFile& file, const MeditFields& fields, std::size_t nodes) {
  constexpr std::size_t longest_head = 100;
  const std::size_t numbers = nodes * medit_row(fields) * sizeof(double);
  const bool wide = numbers + longest_head + 4 * fields.size() > std::numeric_limits<std::int32_t>::max();
  std::string bytes;
  const auto integer = [&](auto value) {
    char to[sizeof(value)];
    bytes.append(to, store(to, value, std::endian::native));
  };
  // A keyword and the place behind `size` bytes of its data.
  const auto keyword = [&](int code, std::size_t size) {
    integer(std::int32_t{code});
    const std::size_t next = code == medit_end ? 0 : bytes.size() + (wide ? 8 : 4) + size;
    wide ? integer(static_cast<std::int64_t>(next)) : integer(static_cast<std::int32_t>(next));
  };
  integer(std::int32_t{1}), integer(std::int32_t{wide ? 3 : 2});
  keyword(medit_dimension, 4);
  integer(std::int32_t{3});
  keyword(medit_sol_at_vertices, 8 + 4 * fields.size() + numbers);
  integer(static_cast<std::int32_t>(nodes)), integer(static_cast<std::int32_t>(fields.size()));
  for (const auto& [values, field] : fields) integer(std::int32_t{field});
  file.write(bytes);
  write_medit_numbers(file, fields, nodes, true);
  bytes.clear();
  keyword(medit_end, 0);
  file.write(bytes);
}

}  // namespace

void write_medit_solution(AtomicFile& file, const MeditFields& fields, std::size_t nodes, bool binary) {
  binary ? write_binary(file, fields, nodes) : write_text(file, fields, nodes);
}

}  // namespace tetproof::io
