// Triangles and edges as three.js draws them, and the colours that they can have.
'use strict';
const drawing = (function () {
  const {scene, decode, tets, tetCount, tetRegions, place, faces} = model;
  const palette = ['#4477aa', '#ee6677', '#228833', '#ccbb44', '#66ccee', '#aa3377',
    '#bbbbbb', '#994455', '#997700', '#44aa99'];
  const ramp = ['#414487', '#2a788e', '#22a884', '#7ad151', '#fde725'].map(c => new THREE.Color(c));
  function rampColour(part) {
    const at = Math.min(Math.max(part, 0), 1) * (ramp.length - 1), k = Math.min(Math.floor(at), ramp.length - 2);
    return ramp[k].clone().lerp(ramp[k + 1], at - k);
  }
  const grey = new THREE.Color('#9aa3ab');
  const valuesOf = scene.layers.map(layer => decode(layer.values, Float32Array));
  let largestValue = 0, anyValue = false;
  for (const values of valuesOf)
    for (const value of values) if (value >= 0) { anyValue = true; if (value > largestValue) largestValue = value; }
  const colourings = {
    plain: {name: 'one colour', of: (layer) => layer.plain},
    region: {
      name: 'region', usable: scene.regions.length > 1,
      of: (layer, tet) => tet < 0 ? layer.plain : new THREE.Color(palette[tetRegions[tet] % palette.length]),
      words: scene.regions.map((name, r) => [name, palette[r % palette.length]]),
    },
    quality: {
      name: 'smallest dihedral angle', usable: tetCount > 0, ends: ['0\u00b0', '70\u00b0'],
      of: (layer, tet) => tet < 0 ? layer.plain : rampColour(model.smallestAngle(tet) / 70),
    },
    value: {
      name: scene.value_name, usable: anyValue, ends: ['0', largestValue.toPrecision(3)],
      of: (layer, tet, i) => {
        const value = layer.values ? layer.values[i] : NaN;
        return value >= 0 ? rampColour(largestValue > 0 ? value / largestValue : 0) : grey;
      },
    },
  };

  // tetOf: of each triangle the tetrahedron that it is a face of; empty: none.
  // colouring: a name in `colourings`.
  function geometryOf(layer, triangles, tetOf, colouring = 'plain') {
    const count = triangles.length / 3, position = new Float32Array(9 * count), colour = new Float32Array(9 * count);
    for (let i = 0; i < count; ++i) {
      const v = triangles.subarray(3 * i, 3 * i + 3);
      const c = colourings[colouring].of(layer, tetOf.length ? tetOf[i] : -1, i);
      for (let k = 0; k < 3; ++k) {
        position.set(place.subarray(3 * v[k], 3 * v[k] + 3), 9 * i + 3 * k);
        colour.set([c.r, c.g, c.b], 9 * i + 3 * k);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(colour, 3));
    geometry.computeVertexNormals();
    return geometry;
  }
  function linesOf(edges, colour) {
    const position = new Float32Array(3 * edges.length);
    for (let i = 0; i < edges.length; ++i) position.set(place.subarray(3 * edges[i], 3 * edges[i] + 3), 3 * i);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: colour}));
  }
  // The sides of triangles. Very many would make all black.
  function sidesOf(triangles, colour) {
    const edges = new Int32Array(2 * triangles.length);
    for (let i = 0; i < triangles.length; i += 3)
      for (let k = 0; k < 3; ++k) edges.set([triangles[i + k], triangles[i + (k + 1) % 3]], 2 * (i + k));
    const lines = linesOf(edges, colour);
    lines.material.transparent = true;
    lines.material.opacity = Math.min(1, Math.max(0.12, 18000 / Math.max(1, triangles.length)));
    return lines;
  }
  function facesOfTets(ids) {   // ids: 4 * tetrahedron + face
    const triangles = new Int32Array(3 * ids.length);
    ids.forEach((id, i) => {
      faces[id & 3].forEach((corner, k) => { triangles[3 * i + k] = tets[4 * (id >>> 2) + corner]; });
    });
    return triangles;
  }
  // Layers may lie in the same place: what has the smaller rank is in front, and edges are in front of all.
  function meshOf(geometry, rank, more) {
    return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(Object.assign({vertexColors: THREE.VertexColors,
      side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: rank, polygonOffsetUnits: rank}, more)));
  }
  return {colourings, rampColour, valuesOf, geometryOf, linesOf, sidesOf, facesOfTets, meshOf};
})();
