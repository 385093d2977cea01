// SPDX-License-Identifier: GPL-3.0-or-later
// Text inside of XML that is written by hand.
#pragma once

#include <string>
#include <string_view>

namespace tetproof::io {

/// Whether XML 1.0 can hold the text at all: UTF-8 without most control characters.
bool is_xml_text(std::string_view text);

/// In an attribute line ends and tabs would become blanks, unless they are references.
enum class XmlLines { keep, in_attribute };

/// The text with references for what XML takes for markup. What XML cannot hold becomes U+FFFD, the
/// replacement character, byte by byte.
std::string xml_escaped(std::string_view text, XmlLines lines = XmlLines::in_attribute);

}  // namespace tetproof::io
