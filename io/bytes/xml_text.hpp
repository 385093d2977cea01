// SPDX-License-Identifier: GPL-3.0-or-later
// Text for XML that is written without a library.
#pragma once

#include <string>
#include <string_view>

namespace tetproof::io {

/// Whether XML 1.0 can hold the text at all: it must be UTF-8 without most control characters.
bool is_xml_text(std::string_view text);

/// In an attribute, readers turn line ends and tabs into blanks unless they are written as references.
enum class XmlLines { keep, in_attribute };

/// The text with references for the characters that XML takes for markup. Each byte that XML cannot hold
/// becomes U+FFFD, the replacement character.
std::string xml_escaped(std::string_view text, XmlLines lines = XmlLines::in_attribute);

}  // namespace tetproof::io
