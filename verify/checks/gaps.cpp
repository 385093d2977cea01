// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/gaps.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "verify/triangles/disjoint_sets.hpp"

namespace tetproof::verify {

void find_covered_faces(const Interface& interface, const FacesAtVertices& at, Gaps& gaps) {
  const auto& contacts = interface.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Index f = contacts[i].triangle;
    if ((i > 0 && contacts[i - 1].triangle == f) || !gaps.free(f)) continue;
    std::vector<Index> faces{f};
    for (const Contact& c : interface.nodes_on(f))
      for (const Index g : at[c.vertex])
        if (gaps.free(g) && interface.within(g, f) && interface.opposite(f, g)) faces.push_back(g);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (faces.size() > 1 && interface.closes(faces)) gaps.add(faces);
  }
}

void find_interfaces(const Interface& interface, const FacesAtVertices& at, Gaps& gaps) {
  std::vector<std::pair<Index, Index>> links;
  for (const Contact& c : interface.contacts())
    for (const Index g : at[c.vertex])
      if (gaps.free(c.triangle) && gaps.free(g) && interface.opposite(c.triangle, g) &&
          interface.coplanar(g, c.triangle))
        links.emplace_back(c.triangle, g);
  if (links.empty()) return;
  DisjointSets sets(gaps.of_face.size());
  for (const auto& [f, g] : links) sets.unite(f, g);
  std::map<Index, std::set<Index>> clusters;
  for (const auto& [f, g] : links) clusters[sets.find(f)].insert({f, g});
  for (const auto& [lowest, cluster] : clusters)
    if (const std::vector<Index> faces(cluster.begin(), cluster.end());
        faces.size() > 1 && interface.closes(faces))
      gaps.add(faces);
}

}  // namespace tetproof::verify
