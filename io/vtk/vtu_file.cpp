// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtu_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_types.hpp"

namespace tetproof::io {

VtuFile::VtuFile(const InputFile& file)
    : file_(file), skeleton_(vtu_skeleton(file)), encoding_{.path = file.path(), .bytes = file.bytes()} {
  const pugi::xml_parse_result parsed =
      xml_.load_buffer_inplace(skeleton_.xml.data(), skeleton_.xml.size(),
                               pugi::parse_minimal | pugi::parse_escapes, pugi::encoding_utf8);
  if (!parsed) fail_at(parsed.offset, fmt::format("expected XML: {}", parsed.description()));
  if (!root()) fail_at(0, "expected <VTKFile>");
  header();
}

void VtuFile::fail_at(std::ptrdiff_t in_xml, std::string_view message) const {
  Scanner(file_.path(), file_.bytes(), std::min(skeleton_.place(in_xml), file_.bytes().size()))
      .fail_in_line(message);
}

std::int64_t VtuFile::line_of(const pugi::xml_node& node) const {
  return Scanner(file_.path(), file_.bytes(), skeleton_.place(node.offset_debug())).line();
}

std::size_t VtuFile::count(const pugi::xml_node& node, const char* attribute, const char* missing) const {
  const char* text = node.attribute(attribute).as_string(missing);
  std::int64_t value = 0;
  if (!parse_integer(text, value) || value < 0)
    fail(node, fmt::format("expected {}, found '{}'", attribute, text));
  if (value > std::numeric_limits<Index>::max())
    fail(node, fmt::format("{} of {} are more than the {} that can be numbered here", attribute, value,
                           std::numeric_limits<Index>::max()));
  return static_cast<std::size_t>(value);
}

void VtuFile::integers_in(const pugi::xml_node& node, const char* attribute,
                          std::span<std::int64_t> to) const {
  const std::string_view text = node.attribute(attribute).value();
  if (text.empty()) return;
  Scanner in(file_.path(), text);
  for (std::int64_t& value : to)
    if (!parse_integer(in.word(), value))
      fail(node, fmt::format("expected {} integers in {}, found '{}'", to.size(), attribute, text));
}

void VtuFile::reals_in(const pugi::xml_node& node, const char* attribute, std::span<double> to) const {
  const std::string_view text = node.attribute(attribute).value();
  if (text.empty()) return;
  Scanner in(file_.path(), text);
  for (double& value : to)
    if (!parse_real(in.word(), value))
      fail(node, fmt::format("expected {} numbers in {}, found '{}'", to.size(), attribute, text));
}

void VtuFile::header() {
  const pugi::xml_node root = this->root();
  const std::string order = root.attribute("byte_order").as_string("LittleEndian");
  if (order != "LittleEndian" && order != "BigEndian")
    fail(root, fmt::format("expected byte_order LittleEndian or BigEndian, found '{}'", order));
  encoding_.order = order == "BigEndian" ? std::endian::big : std::endian::little;
  const std::string header = root.attribute("header_type").as_string("UInt32");
  if (header != "UInt32" && header != "UInt64")
    fail(root, fmt::format("expected header_type UInt32 or UInt64, found '{}'", header));
  encoding_.header_size = header == "UInt64" ? 8 : 4;
  const std::string compressor = root.attribute("compressor").value();
  bool known = true;
  encoding_.packing = packing_of(compressor, known);
  if (!known)
    fail(root, fmt::format("data compressed by {}, expected vtkZLibDataCompressor, vtkLZ4DataCompressor, "
                           "vtkLZMADataCompressor or none",
                           compressor));
  if (skeleton_.appended == 0) return;
  const pugi::xml_node appended = root.child("AppendedData");
  const std::string encoding = appended.attribute("encoding").as_string("base64");
  if (encoding != "raw" && encoding != "base64")
    fail(appended, fmt::format("expected encoding raw or base64, found '{}'", encoding));
  appended_raw_ = encoding == "raw";
  const std::size_t end = file_.bytes().rfind("</AppendedData");
  appended_end_ = end == std::string_view::npos || end < skeleton_.appended ? file_.bytes().size() : end;
}

std::vector<std::int64_t> VtuFile::integers(const pugi::xml_node& node, std::optional<std::size_t> items,
                                            std::vector<Loss>& dropped) const {
  Column values = column(node, items, dropped);
  if (!values.reals.empty() || !values.texts.empty()) fail(node, "expected integers");
  return std::move(values.integers);
}

Column VtuFile::column(const pugi::xml_node& node, std::optional<std::size_t> items,
                       std::vector<Loss>& dropped) const {
  Column column{.name = node.attribute("Name").value(), .type = node.attribute("type").value()};
  const bool bits = column.type == "Bit";
  if (!bits && !is_vtk_type(column.type))
    fail(node, fmt::format("expected the type of an array, found '{}'", column.type));
  const char* components = node.attribute("NumberOfComponents").as_string("1");
  std::int64_t each = 0;
  // VTK wrote 0 for an array without values.
  if (!parse_integer(components, each) || each < 0 || each > std::numeric_limits<std::int32_t>::max())
    fail(node, fmt::format("expected NumberOfComponents, found '{}'", components));
  column.components = each == 0 ? 1 : static_cast<int>(each);
  std::optional<std::size_t> values;
  // Bits do not fill the last byte, so that it does not say how many they are.
  if (bits && !items && node.attribute("NumberOfTuples")) items = count(node, "NumberOfTuples");
  if (items) values = *items * static_cast<std::size_t>(column.components);
  const VtuPlace where = place(node);
  const std::size_t left = read_vtu_array(encoding_, where, values, column);
  if (!where.shared)
    add_loss(dropped, "bytes behind the values of arrays", left, fmt::format("\"{}\"", column.name));
  if (column_size(column) % static_cast<std::size_t>(column.components) != 0)
    fail(node,
         fmt::format("expected a multiple of {} values, found {}", column.components, column_size(column)));
  return column;
}

VtuPlace VtuFile::place(const pugi::xml_node& node) const {
  const std::string format = lower_case(node.attribute("format").as_string("ascii"));
  if (format == "appended") {
    const char* text = node.attribute("offset").value();
    std::int64_t offset = 0;
    if (skeleton_.appended == 0) fail(node, "expected <AppendedData>");
    if (!parse_integer(text, offset) || offset < 0 ||
        static_cast<std::uint64_t>(offset) > appended_end_ - skeleton_.appended)
      fail(node, fmt::format("expected an offset into the {} of appended data, found '{}'",
                             counted(appended_end_ - skeleton_.appended, "bytes"), text));
    return {appended_raw_ ? VtuPlace::raw : VtuPlace::base64,
            skeleton_.appended + static_cast<std::size_t>(offset), appended_end_, true};
  }
  if (format != "ascii" && format != "binary")
    fail(node, fmt::format("expected format ascii, binary or appended, found '{}'", format));
  VtuPlace place{format == "ascii" ? VtuPlace::ascii : VtuPlace::base64, 0, 0};
  std::int64_t text = 0;
  if (*node.child_value() != '\0') {
    if (!parse_integer(node.child_value(), text) || text < 0 ||
        static_cast<std::size_t>(text) >= skeleton_.texts.size())
      fail(node, "expected an array's values in one piece");
    place.begin = skeleton_.texts[static_cast<std::size_t>(text)].begin;
    place.end = skeleton_.texts[static_cast<std::size_t>(text)].end;
  }
  return place;
}

}  // namespace tetproof::io
