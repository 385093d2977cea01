// What the page knows of the mesh: decodes the arrays of the scene (io/page/scene.hpp), and measures tetrahedra in
// doubles. The verdict's own decisions are exact.
'use strict';
const model = (function () {
  const scene = JSON.parse(document.getElementById('scene').textContent);
  function decode(text, Type) {
    const characters = atob(text), bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
    return new Type(bytes.buffer);
  }
  const points = decode(scene.points, Float64Array);
  const short = decode(scene.tets, Uint8Array), tets = new Int32Array(short.length / 3);   // three bytes each
  for (let i = 0; i < tets.length; ++i) tets[i] = short[3 * i] | short[3 * i + 1] << 8 | short[3 * i + 2] << 16;
  const tetCount = tets.length / 4;

  // A position's number in the file. The numbers are stored as runs that count up, or as an array.
  function numbersOf(given) {
    if (given.int32) return decode(given.int32, Int32Array);
    if (given.float64) return decode(given.float64, Float64Array);
    return given;
  }
  function numberOf(numbers, position) {
    if (!Array.isArray(numbers)) return numbers[position];
    let low = 0, high = numbers.length;
    while (high - low > 1) {
      const middle = low + high >> 1;
      if (numbers[middle][0] <= position) low = middle; else high = middle;
    }
    return numbers.length ? numbers[low][1] + position - numbers[low][0] : position;
  }
  const tetNumbers = numbersOf(scene.tet_numbers), pointNumbers = numbersOf(scene.point_numbers);

  // Units: the middle of all points is the origin, and the box has a size of about 1.
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    if (points[i] < low[i % 3]) low[i % 3] = points[i];
    if (points[i] > high[i % 3]) high[i % 3] = points[i];
  }
  if (!points.length) { low.fill(-1); high.fill(1); }
  const middle = low.map((l, k) => l / 2 + high[k] / 2);
  const half = Math.max(...high.map((h, k) => h / 2 - low[k] / 2)) || 1;
  // Halves first: no overflow at the largest doubles.
  const toUnits = (value, k) => (value / 2 - middle[k] / 2) / half;
  const toFile = (value, k) => 2 * (value * half + middle[k] / 2);
  const place = new Float32Array(points.length);
  for (let i = 0; i < points.length; ++i) place[i] = toUnits(points[i], i % 3);

  function corners(t) {
    return [0, 1, 2, 3].map(k => [0, 1, 2].map(c => toUnits(points[3 * tets[4 * t + k] + c], c)));
  }
  const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const faces = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
  function volume(p) { return dot(cross(minus(p[1], p[0]), minus(p[2], p[0])), minus(p[3], p[0])) / 6; }
  function dihedralAngles(p) {   // degrees, of the six edges
    const normals = faces.map(f => cross(minus(p[f[1]], p[f[0]]), minus(p[f[2]], p[f[0]])));
    const angles = [];
    for (let i = 0; i < 4; ++i) for (let j = i + 1; j < 4; ++j) {
      const n = cross(normals[i], normals[j]);
      angles.push(180 - Math.atan2(Math.sqrt(dot(n, n)), dot(normals[i], normals[j])) * 180 / Math.PI);
    }
    return angles;
  }
  let smallestAngles = null;   // of all tetrahedra, when first asked for
  function smallestAngle(t) {
    if (!smallestAngles) smallestAngles = new Float32Array(tetCount).fill(-1);
    if (smallestAngles[t] < 0) {
      const p = corners(t);
      smallestAngles[t] = volume(p) > 0 ? Math.min(...dihedralAngles(p)) : 0;
    }
    return smallestAngles[t];
  }

  // Volumes may be too large or small for doubles in the file's own units.
  function volumeText(v) {
    if (!v) return 'about 0';
    const logarithm = Math.log10(Math.abs(v)) + 3 * Math.log10(2 * half), exponent = Math.floor(logarithm);
    return (v < 0 ? '-' : '') + (exponent > -5 && exponent < 7 ? Math.pow(10, logarithm).toPrecision(6)
      : Math.pow(10, logarithm - exponent).toFixed(5) + 'e' + exponent);
  }
  const tetNumber = t => numberOf(tetNumbers, t), pointNumber = v => numberOf(pointNumbers, v);
  const tetRegions = decode(scene.tet_regions, Int32Array);
  function tetText(t) {
    const p = corners(t), angles = dihedralAngles(p);
    const lines = ['tetrahedron ' + tetNumber(t),
      'points ' + [0, 1, 2, 3].map(k => pointNumber(tets[4 * t + k])).join(', '),
      'volume ' + volumeText(volume(p)),
      'dihedral angles ' + Math.min(...angles).toPrecision(4) + '\u00b0 to '
        + Math.max(...angles).toPrecision(4) + '\u00b0'];
    if (tetRegions.length && scene.regions.length) lines.push('region ' + scene.regions[tetRegions[t]]);
    scene.targets.forEach(target => { if (target.tets.includes(t)) lines.push('named by: ' + target.text); });
    lines.push('(measured by this page in doubles; the verdict is exact)');
    return lines.join('\n');
  }
  return {
    scene, decode, tets, tetCount, tetRegions, tetNumber, pointNumber, low, high, half, toUnits,
    toFile, place, faces, smallestAngle, tetText,
    // Of a ball around everything, in units.
    radius: Math.hypot(...high.map((h, k) => h / 2 - low[k] / 2)) / half / 2,
  };
})();
