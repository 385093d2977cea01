// The cut: whole tetrahedra on one side of a plane, and the faces that one sees of them.
'use strict';
const tetsBehind = (function () {
  const {scene, tets, place, faces} = model;
  const count = scene.cut_tets;
  let neighbours = null;   // of each face of the tetrahedra that can be cut, when first asked for; -1: none
  function findNeighbours() {
    neighbours = new Int32Array(4 * count).fill(-1);
    let size = 1024;
    while (size < 8 * count) size *= 2;
    const table = new Int32Array(size).fill(-1);
    const key = f => {
      const t = f >> 2, k = faces[f & 3];
      return [tets[4 * t + k[0]], tets[4 * t + k[1]], tets[4 * t + k[2]]].sort((a, b) => a - b);
    };
    for (let f = 0; f < 4 * count; ++f) {
      const [a, b, c] = key(f);
      let at = (Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791)) & size - 1;
      for (;; at = at + 1 & size - 1) {
        const other = table[at];
        if (other < 0) { table[at] = f; break; }
        const k = key(other);
        if (k[0] === a && k[1] === b && k[2] === c) {
          neighbours[f] = other >> 2;
          neighbours[other] = f >> 2;
          break;
        }
      }
    }
  }
  // k: 0, 1, 2 for x, y, z. sign 1: what lies towards smaller coordinates is kept.
  return function (k, at, sign) {
    if (!neighbours) findNeighbours();
    const kept = new Uint8Array(count);
    let keptCount = 0;
    for (let t = 0; t < count; ++t) {
      const c = [0, 1, 2, 3].map(i => place[3 * tets[4 * t + i] + k] - at);
      // Of a part of the mesh those that the plane meets; of a whole mesh those whose middle is behind it.
      const behind = scene.cut_anywhere ? sign * (c[0] + c[1] + c[2] + c[3]) <= 0
        : Math.min(...c) <= 0 && Math.max(...c) >= 0;
      if (behind) { kept[t] = 1; ++keptCount; }
    }
    const triangles = [], owners = [];
    for (let t = 0; t < count; ++t) {
      if (!kept[t]) continue;
      for (let f = 0; f < 4; ++f) {
        const other = neighbours[4 * t + f];
        if (other >= 0 && kept[other]) continue;
        for (const i of faces[f]) triangles.push(tets[4 * t + i]);
        owners.push(t);
      }
    }
    return {triangles: Int32Array.from(triangles), tets: Int32Array.from(owners), count: keptCount};
  };
})();
