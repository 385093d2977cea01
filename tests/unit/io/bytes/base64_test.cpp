// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/bytes/base64.hpp"

#include <gtest/gtest.h>

namespace tetproof::io {
namespace {

TEST(Base64, the_examples_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, all_bits) {
  EXPECT_EQ(base64("\xff\xff\xff"), "////");
  EXPECT_EQ(base64(std::string("\0\0\xfb", 3)), "AAD7");
}

}  // namespace
}  // namespace tetproof::io
