// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a document holds: what a file of any format does not give back is exactly what the list of losses
// says.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "documents_compare.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"
#include "random_document.hpp"
#include "tests/support/document_in_order.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {

void PrintTo(const Recipe& recipe, std::ostream* out) {
  *out << recipe;
}

namespace {

// A format and an encoding to write a document in.
struct Target {
  std::string name, file;
  WriteOptions options;
  friend void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }
};

std::vector<Target> all_targets() {
  std::vector<Target> targets;
  for (const Format& format : formats()) {
    if (!format.reads || !(format.ascii || format.binary)) continue;
    for (const bool binary : {false, true}) {
      if (!(binary ? format.binary : format.ascii)) continue;
      const bool both = format.ascii && format.binary;
      targets.push_back(
          {format.name + (!both    ? ""
                          : binary ? "_binary"
                                   : "_text"),
           "x" + (binary && !format.binary_ending.empty() ? format.binary_ending : format.endings.front()),
           {.format = format.name, .binary = binary}});
    }
  }
  return targets;
}

// Most features are off, so a failure has few from the start. RapidCheck removes those that it can.
rc::Gen<Recipe> any_recipe() {
  return rc::gen::map(rc::gen::tuple(rc::gen::inRange<std::uint64_t>(0, 1u << 20), rc::gen::inRange(0, 14),
                                     rc::gen::container<std::array<int, features>>(rc::gen::inRange(0, 12)),
                                     rc::gen::inRange(1, 8)),
                      [](const auto& drawn) {
                        const auto& [seed, nodes, dice, share] = drawn;
                        Recipe recipe{.seed = seed, .nodes = nodes};
                        for (std::size_t i = 0; i < features; ++i) recipe.with[i] = dice[i] > 11 - share;
                        return recipe;
                      });
}

// STL's nodes are only coordinates, so a node with NaN cannot be recognised when it comes back. The triangles
// of polygons can be told apart if there are nodes enough for them: eight, besides loose ones.
void leave_out_what_has_no_identity(Recipe& recipe, const Target& target) {
  if (target.options.format != "stl") return;
  recipe.with[static_cast<std::size_t>(Feature::nan_coordinates)] = false;
  if (recipe.has(Feature::polygons) || recipe.has(Feature::boundary))
    recipe.nodes = std::max(recipe.nodes, 12);
}

using Counts = std::map<std::string, std::int64_t>;

// Whether the example of a loss is one of the subjects that the judge saw. "element 17 in groups 3" belongs
// to "element 17", and not to "element 1".
bool names_one_of(const std::string& example, const std::vector<std::string>& subjects) {
  return std::any_of(subjects.begin(), subjects.end(), [&](const std::string& subject) {
    const std::size_t at = example.find(subject), end = at + subject.size();
    return at != std::string::npos &&
           (end == example.size() || std::isalnum(static_cast<unsigned char>(example[end])) == 0);
  });
}

enum class Said { exactly, at_most };

// The disagreement between the list of losses and the judge; empty if they agree.
std::string disagreement(const std::vector<Loss>& losses, const std::vector<Difference>& differences,
                         Said how = Said::exactly) {
  Counts said, seen;
  std::map<std::string, const Difference*> examples;
  std::string text;
  for (const Loss& loss : losses) {
    said[loss.item] += loss.count;
    for (const Difference& d : differences)
      if (how == Said::exactly && d.item == loss.item && !d.subjects.empty() &&
          !names_one_of(loss.example, d.subjects))
        text += fmt::format("{}: \"{}\" is said as example, but that is not one: {}\n", loss.item,
                            loss.example, d.subjects[0]);
  }
  for (const Difference& d : differences) {
    if (d.unsure && !said.count(d.item)) continue;
    seen[d.item] += d.count;
    examples[d.item] = &d;
  }
  for (const auto& [item, count] : seen)
    if (!said.count(item))
      text += fmt::format("not said: {} ({}): {}\n", item, count, examples[item]->example);
    else if (how == Said::exactly ? said[item] != count : said[item] < count)
      text +=
          fmt::format("{}: said {}, but it was {}: {}\n", item, said[item], count, examples[item]->example);
  for (const auto& [item, count] : said)
    if (how == Said::exactly && !seen.count(item))
      text += fmt::format("said, but not lost: {} ({})\n", item, count);
  return text;
}

class Folder {
 public:
  std::string fresh(const std::string& name) {
    const std::filesystem::path folder = files_.path("x");
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    return folder / name;
  }

 private:
  TestFiles files_;
};

Document there_and_back(Folder& folder, const Document& document, const Target& target) {
  const std::string path = folder.fresh(target.file);
  write_document(path, document, target.options);
  Document back = read_document(path);
  check_in_order(back);
  return back;
}

// A .smesh cannot hold facets of several polygons; writing it is refused.
bool has_place(const Target& target, const Document& document) {
  return target.options.format != "smesh" || document.facets.empty();
}

// Whether the format keeps aside what it has no place for.
bool has_supplement(const Target& target) {
  const std::string& format = target.options.format;
  return format.starts_with("msh") || format == "tetgen" || format == "poly" || format == "smesh";
}

// In formats with a supplement elements may name any number, and also in Medit files if nodes are 1, 2, ...
// In other formats elements name nodes by position.
Holding holding(const Target& target, const Document& document) {
  const std::string& format = target.options.format;
  if (format == "stl") return Holding::triangles;
  const bool any =
      has_supplement(target) || (format == "medit" && document.node_tags.empty() && document.first_node == 1);
  return any ? Holding::elements : Holding::elements_of_nodes;
}

// What is missing in `after`, except for what a Medit file never said: numbers and the order of its elements.
// Ghost elements of .msh 4 get entities, without which Gmsh has none.
std::vector<Difference> said_and_missing(const Document& before, const Document& after, Holding holding) {
  std::vector<Difference> seen = differences(before, after, holding);
  if (!before.ghost_elements.empty())
    std::erase_if(seen, [](const Difference& d) { return d.item == "gained entities of ghost elements"; });
  if (before.format == "medit")
    std::erase_if(seen, [](const Difference& d) {
      return d.item == "numbers of elements" || d.item == "order of elements";
    });
  return seen;
}

class RoundTrip : public testing::TestWithParam<Target> {};

TEST_P(RoundTrip, LosesWhatItSays) {
  const Target& target = GetParam();
  Folder folder;
  EXPECT_TRUE(rc::check(target.name, [&] {
    Recipe recipe = *any_recipe();
    leave_out_what_has_no_identity(recipe, target);
    const Document document = random_document(recipe);
    check_in_order(document);
    if (!has_place(target, document)) return;
    const std::vector<Loss> said = losses(target.file, document, target.options);
    const Document back = there_and_back(folder, document, target);
    if (!back.dropped.empty())  // our readers accept everything that our writers write
      RC_FAIL(
          fmt::format("{}: not read: {}: {}", target.name, back.dropped[0].item, back.dropped[0].example));
    const std::string wrong = disagreement(said, said_and_missing(document, back, holding(target, document)));
    if (!wrong.empty()) RC_FAIL(fmt::format("{}: {}", target.name, wrong));
  }));
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::ValuesIn(all_targets()),
                         [](const auto& test) { return test.param.name; });

// What is kept aside is in a section at the end of a .msh file, and in comments of TetGen's files. Cuts it
// off every file in the folder; returns whether there was any.
bool cut_supplements(const std::filesystem::path& folder) {
  bool any = false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}}, left;
    if (entry.path().extension() == ".msh") {
      left = bytes.substr(0, bytes.rfind("$TetproofSupplement\n"));
    } else {
      for (std::size_t at = 0, end = 0; at < bytes.size(); at = end) {
        end = std::min(bytes.find('\n', at), bytes.size() - 1) + 1;
        if (bytes.compare(at, 2, "#:") != 0) left += bytes.substr(at, end - at);
      }
    }
    any = any || left != bytes;
    std::ofstream(entry.path(), std::ios::binary | std::ios::trunc) << left;
  }
  return any;
}

// Whether it is something that a writer adds for other programs: entities, without which .msh 4 has no groups
// and partitions; TetGen's attributes and markers instead of groups, and groups instead of these.
bool is_for_others(const std::string& item, const Target& target, const std::vector<Loss>& said) {
  if (target.options.format.starts_with("msh"))
    return item == "gained entities" || item == "gained entities of ghost elements";
  if (item == "changed physical groups" || item == "physical groups beyond an element's first")
    return std::any_of(said.begin(), said.end(), [](const Loss& loss) {
      return loss.item == "values \"attributes\" of elements" ||
             loss.item == "values \"markers\" of elements";
    });
  return (item == "gained values \"attributes\" of elements" ||
          item == "gained values \"markers\" of elements") &&
         std::any_of(said.begin(), said.end(),
                     [](const Loss& loss) { return loss.item == "physical groups of elements"; });
}

// Makes integers of the reals that were integers, and lists these values.
std::vector<Difference> integers_again(const Document& before, Document& after) {
  std::vector<Difference> made;
  const auto again = [&](const std::vector<Values>& was, std::vector<Values>& is, const char* whose) {
    for (Values& values : is) {
      const bool of_integers = std::any_of(was.begin(), was.end(), [&](const Values& v) {
        return v.name == values.name && v.components == values.components && !v.integers.empty() &&
               v.integers.size() == values.reals.size();
      });
      if (!of_integers || values.reals.empty()) continue;
      for (const double real : values.reals) values.integers.push_back(static_cast<std::int64_t>(real));
      values.reals.clear();
      made.push_back({fmt::format("that values of {} are integers, not reals", whose), 1,
                      fmt::format("\"{}\"", values.name)});
    }
  };
  again(before.node_values, after.node_values, "nodes");
  again(before.element_values, after.element_values, "elements");
  again(before.element_node_values, after.element_node_values, "elements' nodes");
  return made;
}

class KeptAsideProperty : public testing::TestWithParam<Target> {};

// Without the supplement, everything that is missing is listed as kept aside. Less may be missing, because
// parts such as entities are kept aside whole if the file has only some of them.
TEST_P(KeptAsideProperty, IsWhatOthersDoNotSee) {
  const Target& target = GetParam();
  Folder folder;
  EXPECT_TRUE(rc::check(target.name, [&] {
    const Recipe recipe = *any_recipe();
    const Document document = random_document(recipe);
    if (!has_place(target, document)) return;
    std::vector<Loss> said = losses(target.file, document, target.options);
    const KeptAside aside = kept_aside(target.file, document, target.options);
    said.insert(said.end(), aside.items.begin(), aside.items.end());
    const std::string path = folder.fresh(target.file);
    write_document(path, document, target.options);
    RC_ASSERT(cut_supplements(std::filesystem::path(path).parent_path()) == !aside.items.empty());
    Document back = read_document(path);
    check_in_order(back);
    const std::vector<Difference> reals = integers_again(document, back);
    std::vector<Difference> seen = differences(document, back);
    seen.insert(seen.end(), reals.begin(), reals.end());
    std::erase_if(seen, [&](const Difference& d) { return is_for_others(d.item, target, said); });
    const std::string wrong = disagreement(said, seen, Said::at_most);
    if (!wrong.empty()) RC_FAIL(fmt::format("{}: {}", target.name, wrong));
  }));
}

std::vector<Target> targets_with_supplements() {
  std::vector<Target> targets = all_targets();
  std::erase_if(targets, [](const Target& target) { return !has_supplement(target); });
  return targets;
}

INSTANTIATE_TEST_SUITE_P(Formats, KeptAsideProperty, testing::ValuesIn(targets_with_supplements()),
                         [](const auto& test) { return test.param.name; });

// A -> B -> A: everything in the first A comes back, except for the losses that were listed on the way.
TEST(RoundTrips, AllPairs) {
  const std::vector<Target> targets = all_targets();
  Folder folder;
  EXPECT_TRUE(rc::check("A -> B -> A", [&] {
    Recipe recipe = *any_recipe();
    const Target& a = targets[*rc::gen::inRange<std::size_t>(0, targets.size())];
    const Target& b = targets[*rc::gen::inRange<std::size_t>(0, targets.size())];
    leave_out_what_has_no_identity(recipe, a);
    leave_out_what_has_no_identity(recipe, b);
    const Document document = random_document(recipe);
    if (!has_place(a, document) || !has_place(b, document)) return;
    const Document first = there_and_back(folder, document, a);
    std::vector<Loss> said = losses(b.file, first, b.options);
    const Document second = there_and_back(folder, first, b);
    std::string wrong = disagreement(said, said_and_missing(first, second, holding(b, first)));
    if (!wrong.empty()) RC_FAIL(fmt::format("{} -> {}: {}", a.name, b.name, wrong));
    const std::vector<Loss> more = losses(a.file, second, a.options);
    Document third = there_and_back(folder, second, a);
    wrong = disagreement(more, said_and_missing(second, third, holding(a, second)));
    if (!wrong.empty()) RC_FAIL(fmt::format("{} -> {} -> {}: {}", a.name, b.name, a.name, wrong));
    said.insert(said.end(), more.begin(), more.end());
    third.format = second.format;  // which may have had no names for values
    // An entity of all nodes is not a loss, and may come back with another number.
    const bool one_entity = first.node_blocks.size() == 1;
    // Entities of elements that one format loses come back from the other one as entity 1.
    const auto tells = [](const Loss& loss, const Difference& d) {
      return loss.item == d.item || (loss.item == "entities of elements" && d.item == "numbers of entities");
    };
    // Numbers that only count up from 0 or 1 tell nothing, but others may have become such numbers.
    const auto plain = [](const Document& d) {
      return d.element_tags.empty() && (d.first_element == 0 || d.first_element == 1);
    };
    const bool numbers_say_nothing = plain(second) && plain(third);
    for (const Difference& d :
         said_and_missing(first, third, std::max(holding(b, first), holding(a, second))))
      if (!d.unsure && !(second.format == "medit" && d.item == "order of elements") &&
          !(one_entity && d.item == "entities of nodes") &&
          !(numbers_say_nothing && d.item == "numbers of elements") &&
          std::none_of(said.begin(), said.end(), [&](const Loss& loss) { return tells(loss, d); }))
        RC_FAIL(fmt::format("{} -> {} -> {}: not said: {} ({}): {}", a.name, b.name, a.name, d.item, d.count,
                            d.example));
  }));
}

}  // namespace
}  // namespace tetproof::test
