// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/medit/medit_solution_write.hpp"

#include <fmt/format.h>

#include <bit>
#include <limits>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/text_output.hpp"
#include "io/medit/medit_keywords.hpp"

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

void write_text(AtomicFile& file, const std::vector<MeditSolutionPart>& parts) {
  file.write("MeshVersionFormatted 2\n\nDimension 3\n");
  for (const auto& [keyword, fields, items] : parts) {
    file.write(fmt::format("\n{}\n{}\n{}", keyword->name, items, fields.size()));
    for (const auto& [values, field] : fields) file.write(fmt::format(" {}", field));
    file.write("\n");
    write_medit_numbers(file, fields, items, false);
  }
  file.write("\nEnd\n");
}

std::size_t bytes_of_numbers(const MeditSolutionPart& part) {
  return part.items * medit_row(part.fields) * sizeof(double);
}

void write_binary(AtomicFile& file, const std::vector<MeditSolutionPart>& parts) {
  std::size_t size = 100;
  for (const MeditSolutionPart& part : parts) size += 100 + 4 * part.fields.size() + bytes_of_numbers(part);
  const bool wide = size > std::numeric_limits<std::int32_t>::max();
  std::size_t written = 0;
  std::string bytes;
  const auto integer = [&](auto value) {
    char to[sizeof(value)];
    bytes.append(to, store(to, value, std::endian::native));
  };
  // A keyword and the place behind so many bytes of its data.
  const auto keyword = [&](int code, std::size_t data_bytes) {
    integer(std::int32_t{code});
    const std::size_t next = code == medit_end ? 0 : written + bytes.size() + (wide ? 8 : 4) + data_bytes;
    wide ? integer(static_cast<std::int64_t>(next)) : integer(static_cast<std::int32_t>(next));
  };
  integer(std::int32_t{1}), integer(std::int32_t{wide ? 3 : 2});
  keyword(medit_dimension, 4);
  integer(std::int32_t{3});
  for (const MeditSolutionPart& part : parts) {
    keyword(part.keyword->code, 8 + 4 * part.fields.size() + bytes_of_numbers(part));
    integer(static_cast<std::int32_t>(part.items)), integer(static_cast<std::int32_t>(part.fields.size()));
    for (const auto& [values, field] : part.fields) integer(std::int32_t{field});
    file.write(bytes);
    write_medit_numbers(file, part.fields, part.items, true);
    written += bytes.size() + bytes_of_numbers(part);
    bytes.clear();
  }
  keyword(medit_end, 0);
  file.write(bytes);
}

}  // namespace

void write_medit_solution(AtomicFile& file, const std::vector<MeditSolutionPart>& parts, bool binary) {
  binary ? write_binary(file, parts) : write_text(file, parts);
}

}  // namespace tetproof::io
