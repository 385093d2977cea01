/* SPDX-License-Identifier: GPL-3.0-or-later
 * The C interface of tetproof, for every language that can call C: judges tetrahedral meshes, reads and
 * writes mesh files, generates surfaces, and cuts grids from them. Link libtetproof (pkg-config tetproof, or
 * tetproof::c of the CMake package). README.md beside this header in the sources has an example.
 *
 * Errors. A function that can fail returns a tetproof_status, and takes a `tetproof_error*` as its last
 * argument, which may be null. The error is the caller's own struct of fixed size, so that there is no global
 * or thread-local state, nothing to free, and out-of-memory can be reported without memory. Its message is
 * one line. After a failure all results are null, and nothing was written.
 *
 * The library never exits, prints nothing, and lets no exception out. There are two limits. Two libraries
 * that it uses abort the process when they get no memory: GMP, for exact numbers, and nlohmann's JSON, for
 * the functions that return JSON; both need little. And the caller must own the memory that it describes: a
 * wrong pointer, or a count beyond the array's end, cannot be seen from here.
 *
 * Threads. Every function may be called from any number of threads at once, also with the same objects, as
 * long as none of them frees or changes (tetproof_document_name_group) an object that others use. Inside, a
 * function uses all processors, unless its options say otherwise; results do not depend on the number of
 * threads. Nor do they depend on the caller's floating-point environment (rounding direction, flushing to
 * zero), which is set aside during a call.
 *
 * Memory. What a function returns through `char**` is freed with tetproof_text_free, objects with the
 * function of their name. The free functions take null. A `const` pointer that is returned belongs to the
 * object that was asked, and is valid until that is freed.
 *
 * Growth. Options begin with their size, which their init function sets. A size that this version does not
 * know is refused. The structs of arrays and errors never change. Records, which the library makes, may get
 * more members at their end: use their pointers, and do not copy arrays of them.
 *
 * Texts are UTF-8 and end with a zero byte. Enumerations are int32_t in every struct, so that a value which
 * is none of them is refused and not undefined. Truth values are 0 and 1. */
#ifndef TETPROOF_H
#define TETPROOF_H

#include <stddef.h>
#include <stdint.h>

#define TETPROOF_VERSION_MAJOR 0
#define TETPROOF_VERSION_MINOR 1
#define TETPROOF_VERSION_PATCH 0
#define TETPROOF_VERSION_STRING "0.1.0"

#if defined(__GNUC__)
#define TETPROOF_API __attribute__((visibility("default")))
#else
#define TETPROOF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the library that is loaded: TETPROOF_VERSION_STRING of its own header. */
TETPROOF_API const char* tetproof_version(void);

/* --- Errors ------------------------------------------------------------------------------------------- */

typedef int32_t tetproof_status;
enum {
  TETPROOF_OK = 0,
  TETPROOF_BAD_ARGUMENT = 1, /* a mistake in the calling code: a null pointer, a negative count, an option out
                                of its range, an unknown id of a check */
  TETPROOF_BAD_INPUT = 2,    /* something that a user can correct: a file, a specification, a surface that is
                                not closed, a mesh without tetrahedra */
  TETPROOF_TOO_LARGE = 3,   /* more points, triangles or tetrahedra than 2147483647: positions have 32 bits */
  TETPROOF_LOSSY = 4,       /* `strict` was asked for, and the file would not hold everything */
  TETPROOF_OUT_OF_TIME = 5, /* the deadline passed */
  TETPROOF_OUT_OF_MEMORY = 6,
  TETPROOF_INTERNAL = 7 /* a fault of the library: please report it with the input */
};

/* Nothing needs to be set before it is passed. After success the status is TETPROOF_OK and the message
 * empty. A message that does not fit is cut at a character, and ends in "...". */
typedef struct tetproof_error {
  tetproof_status status;
  char message[1020];
} tetproof_error;

/* "TETPROOF_OUT_OF_TIME"; "unknown status" for other numbers. The text is static. */
TETPROOF_API const char* tetproof_status_name(tetproof_status status);

/* Frees a text that a function returned through `char**`. */
TETPROOF_API void tetproof_text_free(char* text);

/* --- Arrays of the caller ----------------------------------------------------------------------------- */

/* Points of three doubles [length]. The k-th coordinate of point i stands at the byte
 * i * stride + k * component_stride of `data`. A stride of 0 means packed: component_stride 8, stride 24.
 * Strides may be negative, and need not be multiples of 8. Rows x y z of a C array: {data, count, 0, 0}; a
 * Fortran array POINTS(n, 3): {data, n, 8, 8 * n}. NaN and infinity are no errors of the call: the judge
 * names the points. */
typedef struct tetproof_points {
  const void* data;
  int64_t count;
  int64_t stride;           /* bytes from a point to the next */
  int64_t component_stride; /* bytes from x to y, and from y to z */
} tetproof_points;

/* Signed integers: four of a tetrahedron, three of a triangle, one of a tag. Strides as of points; packed is
 * component_stride bits / 8, and stride as many of them as an item has integers.
 *
 * `base` is the number of the first point: 0 in C, 1 in Fortran, Julia and MATLAB. It is also the number of
 * the first tetrahedron or triangle: a report names all by these numbers. It is between -2^62 and 2^62, and 0
 * for tags. An index that names no point is no error of the call: the judge names its tetrahedron. */
typedef struct tetproof_integers {
  const void* data;
  int64_t count;
  int64_t stride;           /* bytes from an item to the next */
  int64_t component_stride; /* bytes from an integer of an item to its next */
  int64_t base;
  int32_t bits; /* 32 or 64 */
} tetproof_integers;

typedef struct tetproof_surface tetproof_surface;
typedef struct tetproof_document tetproof_document;
typedef struct tetproof_report tetproof_report;

/* --- Surfaces ----------------------------------------------------------------------------------------- */

/* A surface from arrays. A triangle a b c has (b-a) x (c-a) pointing out of the solid. Equal vertices are
 * welded, as they are when a file is read. BAD_INPUT: a triangle names a vertex that does not exist, or there
 * are no triangles. Whether it is closed and free of self-intersections is judged when a mesh is compared
 * with it, or by tetproof_surface_fault. */
TETPROOF_API tetproof_status tetproof_surface_from_arrays(const tetproof_points* vertices,
                                                          const tetproof_integers* triangles,
                                                          tetproof_surface** surface, tetproof_error* error);

/* A generated surface ("sphere:r=1,n=500"; tetproof_list_surfaces lists them), or the surface in a file of
 * any format. `format`: read the file as this format ("stl", "msh41", ...); null: its content and ending
 * decide. BAD_INPUT, with the place in the file. */
TETPROOF_API tetproof_status tetproof_surface_open(const char* file_or_spec, const char* format,
                                                   tetproof_surface** surface, tetproof_error* error);

/* The faces of a document: triangles as they are, larger polygons cut into triangles. BAD_INPUT: it has
 * none. */
TETPROOF_API tetproof_status tetproof_surface_from_document(const tetproof_document* document,
                                                            tetproof_surface** surface,
                                                            tetproof_error* error);

TETPROOF_API void tetproof_surface_free(tetproof_surface* surface);

/* A surface as packed arrays, counted from 0. */
typedef struct tetproof_surface_arrays {
  int64_t vertex_count, triangle_count;
  const double* vertices;   /* x y z of each [length] */
  const int32_t* triangles; /* three positions in `vertices` of each */
  const double* parameters; /* (u,v) at each corner of each triangle, six numbers a triangle; null: none */
} tetproof_surface_arrays;

/* The arrays; null if `surface` is null. */
TETPROOF_API const tetproof_surface_arrays* tetproof_surface_view(const tetproof_surface* surface);

/* Judges the surface. `fault` becomes null if it is closed, manifold, oriented and free of
 * self-intersections; or else one line that says what is wrong and where. */
TETPROOF_API tetproof_status tetproof_surface_fault(const tetproof_surface* surface, char** fault,
                                                    tetproof_error* error);

/* A JSON object: what the reader of the surface's file warned of (`warnings`, an array of texts) and did not
 * take (`dropped`, an array of objects with `item`, `count` and `example`). */
TETPROOF_API tetproof_status tetproof_surface_json(const tetproof_surface* surface, char** json,
                                                   tetproof_error* error);

/* A text for users: each generated surface with its parameters. */
TETPROOF_API tetproof_status tetproof_list_surfaces(char** text, tetproof_error* error);

/* --- The judge ---------------------------------------------------------------------------------------- */

enum {
  TETPROOF_REGION_DEFAULT = 0, /* inside where a surface is given, else none */
  TETPROOF_REGION_NONE = 1,
  TETPROOF_REGION_INSIDE = 2, /* the mesh fills the surface */
  TETPROOF_REGION_OUTSIDE = 3 /* it fills the space between the surface and a boundary of its own */
};

/* The options of tetproof-verify, with the same defaults. verify/checks/checks.md explains the checks. */
typedef struct tetproof_judge_options {
  size_t size;     /* set by tetproof_judge_options_init */
  int32_t region;  /* TETPROOF_REGION_...; inside and outside need a surface */
  int32_t voxels;  /* along the longest side, for the second account of volume: 0 (none) to 1024 [128] */
  double fidelity; /* allowed distance [diagonals of the surface's box]; 0: exactly [1e-3] */
  double deadline; /* seconds after which the call gives up with OUT_OF_TIME, which it looks at between its
                      stages and while it measures distances; 0: none [0] */
  int32_t threads; /* at most so many, 1 to 4096; 0: all processors [0] */
  int32_t strict_topology; /* topology, cavities and non-manifold places fail instead of warn [0] */
  int32_t coarse;          /* for a mesh made from a lattice with cells as wide as the allowed distance: parts
                              thinner than a cell only warn, and distances are only compared [0] */
  int32_t decide_only;     /* distances are compared with the allowed one, and not measured closely [0] */
  int32_t only_tets;       /* elements of other shapes count as left out, not as unjudged [0] */
  int32_t quality;         /* measure angles and aspect ratios, for the record and JSON [1] */
  int32_t timings;         /* seconds of each phase in the JSON, which then differs from run to run [0] */
  const char* check;       /* ids of checks, separated by commas: only these. Null or "": all */
  const char* skip;        /* all except these */
  const char* allow;       /* findings of these only warn: crack, non-conforming-interface */
  const char* region_kind; /* what the tags of `regions` are: "physical", "entity", "attribute" or
                              "reference", as in the JSON of a file; null or "": only numbers */
} tetproof_judge_options;

/* Sets all options to their defaults. `size`: sizeof(tetproof_judge_options). BAD_ARGUMENT: another size. */
TETPROOF_API tetproof_status tetproof_judge_options_init(tetproof_judge_options* options, size_t size,
                                                         tetproof_error* error);

/* Judges a mesh as it is written: nothing is re-wound, merged or repaired. A positive tetrahedron a b c d has
 * (b-a) x (c-a) . (d-a) > 0. A mesh with defects is no error of the call: see the report.
 *
 * `regions`: a tag for each tetrahedron; null: one region. Regions may share faces, and each gets its own
 * account. `surface`: what the mesh should fill; null: none. `options`: null for the defaults.
 *
 * BAD_INPUT: there are no tetrahedra, or the surface is not usable. */
TETPROOF_API tetproof_status tetproof_judge(const tetproof_points* points, const tetproof_integers* tets,
                                            const tetproof_integers* regions, const tetproof_surface* surface,
                                            const tetproof_judge_options* options, tetproof_report** report,
                                            tetproof_error* error);

/* Judges the tetrahedra of a document, as tetproof-verify judges a file: elements of other shapes, curved
 * ones and those that the reader dropped are named as not judged, and groups are the regions. */
TETPROOF_API tetproof_status tetproof_judge_document(const tetproof_document* document,
                                                     const tetproof_surface* surface,
                                                     const tetproof_judge_options* options,
                                                     tetproof_report** report, tetproof_error* error);

TETPROOF_API void tetproof_report_free(tetproof_report* report);

/* The report as JSON: the bytes that `tetproof-verify --json` writes for the same mesh in a file. The keys
 * are a contract: share/tetproof/report.schema.json. */
TETPROOF_API tetproof_status tetproof_report_json(const tetproof_report* report, char** json,
                                                  tetproof_error* error);
/* The report for people, as tetproof-verify prints it (without "FILE: "). */
TETPROOF_API tetproof_status tetproof_report_text(const tetproof_report* report, char** text,
                                                  tetproof_error* error);
/* The report as JUnit XML; `mesh` is the name of the test suite. */
TETPROOF_API tetproof_status tetproof_report_junit(const tetproof_report* report, const char* mesh,
                                                   char** xml, tetproof_error* error);

/* The report as a page of HTML that opens from disk in any browser, with the mesh, the surface and the
 * defects in three dimensions: the bytes that `tetproof-verify --html` writes. The mesh and the surface
 * (null: none) are those of the report; `mesh_name` is what the mesh is called on the page, and a
 * surface of arrays is called "surface". BAD_ARGUMENT: other counts of points, tetrahedra or triangles. */
TETPROOF_API tetproof_status tetproof_report_html(const tetproof_report* report,
                                                  const tetproof_points* points,
                                                  const tetproof_integers* tets,
                                                  const tetproof_surface* surface, const char* mesh_name,
                                                  char** html, tetproof_error* error);
TETPROOF_API tetproof_status tetproof_report_document_html(const tetproof_report* report,
                                                           const tetproof_document* document,
                                                           const tetproof_surface* surface,
                                                           const char* mesh_name, char** html,
                                                           tetproof_error* error);

/* The broken elements for a viewer, with one ring of tetrahedra around them: the document that
 * `tetproof-verify --defects` writes; .vtu is for ParaView. The mesh is that of the report, as arrays or as a
 * document. BAD_ARGUMENT: it has other counts of points and tetrahedra. */
TETPROOF_API tetproof_status tetproof_report_defects(const tetproof_report* report,
                                                     const tetproof_points* points,
                                                     const tetproof_integers* tets,
                                                     tetproof_document** defects, tetproof_error* error);
TETPROOF_API tetproof_status tetproof_report_document_defects(const tetproof_report* report,
                                                              const tetproof_document* document,
                                                              tetproof_document** defects,
                                                              tetproof_error* error);

/* --- The report as plain records ---------------------------------------------------------------------- */
/* In all records: a double that is not known is NaN, a count that is not known is -1. Numbers of tetrahedra,
 * points and faces are the caller's own, from `base` on, or those of the document's file. Positions count
 * from 0. */

enum { TETPROOF_SOUND = 0, TETPROOF_DEFECTIVE = 1, TETPROOF_INCOMPLETE = 2 };

enum {
  TETPROOF_CHECK_PASS = 0,
  TETPROOF_CHECK_WARNING = 1,
  TETPROOF_CHECK_FAIL = 2,
  TETPROOF_CHECK_UNDECIDED = 3,
  TETPROOF_CHECK_SKIPPED = 4
};

/* So many findings of another check. */
typedef struct tetproof_consequence {
  const char* check; /* its id */
  int64_t count;
} tetproof_consequence;

/* A place where a check does not hold. */
typedef struct tetproof_finding {
  int64_t tet_count;
  const int64_t* tets;          /* their numbers */
  const int64_t* tet_positions; /* and their positions among the tetrahedra */
  int64_t tet_run_count;        /* if it concerns more tetrahedra than `tets` lists: all of them, as runs */
  const int64_t* tet_runs;      /* the first and last number of each run */
  int64_t vertex_count;
  const int64_t* vertices;         /* numbers; an index that names no point is given as it is written */
  const int64_t* vertex_positions; /* -1: no point */
  int64_t face_count;
  const int64_t* faces; /* three numbers of vertices each */
  int32_t has_point;
  double point[3];            /* [length], rounded from `point_exact` where that is given; else exact */
  const char* point_exact[3]; /* rational numbers "n/d"; null where `point` is exact */
  const char* what;           /* one line; empty if the numbers say it all */
  int64_t consequence_count;
  const tetproof_consequence* const* consequences; /* findings of other checks that follow from this one */
} tetproof_finding;

typedef struct tetproof_check {
  const char* id;        /* stable: "inverted" */
  int32_t verdict;       /* TETPROOF_CHECK_... */
  int32_t exact;         /* it rests on exact decisions alone */
  int64_t count;         /* all findings that are not consequences of others */
  int64_t consequences;  /* findings that are, and are counted there */
  double measured;       /* in the unit that checks.md gives */
  double allowed;        /* likewise */
  const char* why;       /* the reason if it was skipped; else empty */
  int64_t finding_count; /* the first of those that `count` counts, at most 100 */
  const tetproof_finding* const* findings;
} tetproof_check;

/* Elements or checks that the verdict does not cover. */
typedef struct tetproof_not_judged {
  const char* what; /* "hexahedra", "check volume-voxel" */
  int64_t count;
  const char* why;
} tetproof_not_judged;

/* Counts and volume of a mesh, a region or a surface. Components, cavities and genus (the sum over the
 * components) are those of the boundary. */
typedef struct tetproof_shape {
  int64_t points, tets, boundary_faces; /* of a surface: vertices, 0, triangles */
  int64_t components, cavities, genus;
  int64_t genus_count;
  const int64_t* genus_per_component;
  double volume; /* [length^3], the exact volume rounded once */
} tetproof_shape;

typedef struct tetproof_region {
  int64_t tag;
  const char* kind; /* "physical", ...; empty: only a number */
  const char* name; /* of a physical group; empty: none */
  tetproof_shape shape;
} tetproof_region;

/* [length^3]; the relative difference is a fraction. */
typedef struct tetproof_volume {
  double mesh, surface, relative_difference; /* exact values, rounded once */
  double voxel_inside, voxel_error_bound, voxel_error_estimate;
  double missing, excess; /* of regions, by voxels */
} tetproof_volume;

/* Directed Hausdorff distances [length]: each is at least the given value, and at most error_bound more. */
typedef struct tetproof_fidelity {
  double mesh_to_surface, surface_to_mesh, error_bound, allowed;
} tetproof_fidelity;

/* counts[i] values lie in [edges[i], edges[i+1]); the last interval has no upper end, and the first has
 * smaller values, too. */
typedef struct tetproof_distribution {
  double min, max;
  int64_t bin_count;
  const double* edges;
  const int64_t* counts;
} tetproof_distribution;

typedef struct tetproof_quality {
  int64_t tets;                          /* that were measured: those of positive volume */
  tetproof_distribution dihedral_angles; /* [degrees], six a tetrahedron */
  tetproof_distribution solid_angles;    /* [4 pi], four a tetrahedron */
  tetproof_distribution aspect_ratios;   /* longest edge / (2 sqrt(6) inradius) */
} tetproof_quality;

typedef struct tetproof_records {
  int32_t verdict;     /* TETPROOF_SOUND, ... */
  int32_t certificate; /* 1: proved to be a valid triangulation of a solid; 0: it is none; -1: not decided */
  int32_t by_corners;  /* there are curved tetrahedra, judged by their corners */
  int64_t check_count; /* one for each check, causes first */
  const tetproof_check* const* checks;
  int64_t not_judged_count; /* with any of them no verdict is sound */
  const tetproof_not_judged* const* not_judged;
  int64_t left_out_count; /* by the options */
  const tetproof_not_judged* const* left_out;
  int64_t allowed_count; /* findings that the option `allow` names */
  const tetproof_consequence* const* allowed;
  const tetproof_shape* mesh;
  const tetproof_shape* surface; /* null: none was given */
  int64_t region_count;          /* 0: there is only one */
  const tetproof_region* const* regions;
  const tetproof_volume* volume;
  const tetproof_fidelity* fidelity; /* null: no distance was measured */
  const tetproof_quality* quality;   /* null: not measured */
  int64_t note_count;
  const char* const* notes;
  /* If faults concern the mesh as a whole (all tetrahedra in the other order, numbers shifted by one): what
   * a second judgement finds without them. `mended_how` is null if there are none. */
  const char* mended_how;
  int32_t mended_certificate;
  int64_t mended_check_count;
  const tetproof_check* const* mended_checks;
} tetproof_records;

/* The records; null if `report` is null. */
TETPROOF_API const tetproof_records* tetproof_report_records(const tetproof_report* report);

/* The table of checks. */
typedef struct tetproof_check_info {
  const char* id;
  const char* proves;   /* the statement that it proves, or what it measures */
  const char* accuracy; /* "exact", or the error that it states */
  int32_t severity;     /* 0: its findings fail; 1: they warn; 2: they warn, and fail with strict_topology */
  int32_t needs_surface;
  int32_t for_certificate;
} tetproof_check_info;

/* The check at `position` in the report's order, which is never freed; null if there is none. */
TETPROOF_API const tetproof_check_info* tetproof_check_info_at(int32_t position);

/* --- Documents: everything in a mesh file ------------------------------------------------------------- */

/* Reads a file of any format that tetproof-convert reads; files of TetGen and Medit bring those that stand
 * beside them. What only Gmsh reads (.step, .geo, ...) goes through a child process, tetproof-gmsh-import;
 * the environment variable TETPROOF_GMSH_IMPORT says where it is, if it is not where it was installed.
 * `format`: as of tetproof_surface_open. "-" is a file of that name. BAD_INPUT, with the place in the file.
 */
TETPROOF_API tetproof_status tetproof_document_read(const char* path, const char* format,
                                                    tetproof_document** document, tetproof_error* error);

/* Reads a file that is in memory, `size` bytes. It has no name, so that its content decides the format, or
 * `format`. BAD_INPUT: likewise, and for a mesh of TetGen, which is several files. */
TETPROOF_API tetproof_status tetproof_document_read_memory(const void* bytes, size_t size, const char* format,
                                                           tetproof_document** document,
                                                           tetproof_error* error);

/* A document from arrays, each of which but `points` may be null. Groups: a tag for each tetrahedron and
 * triangle, 0 (no group) to 2147483647; they become physical groups. Numbers in files count from the `base`
 * of `tets` and `triangles`, which must be the same. An index that names no point stays as it is. */
TETPROOF_API tetproof_status tetproof_document_from_arrays(
    const tetproof_points* points, const tetproof_integers* tets, const tetproof_integers* tet_groups,
    const tetproof_integers* triangles, const tetproof_integers* triangle_groups,
    tetproof_document** document, tetproof_error* error);

/* Names a physical group, in place of the name that it had. `dimension`: 3 of tetrahedra, 2 of triangles, 0
 * to 3. Changes the document: no other thread may use it meanwhile. */
TETPROOF_API tetproof_status tetproof_document_name_group(tetproof_document* document, int32_t dimension,
                                                          int64_t tag, const char* name,
                                                          tetproof_error* error);

TETPROOF_API void tetproof_document_free(tetproof_document* document);

typedef struct tetproof_group {
  int32_t dimension;
  int64_t tag;
  const char* name;
} tetproof_group;

/* The points, tetrahedra and triangles of a document as packed arrays. Elements of higher order are given by
 * their corners. A negative corner -1-k stands for the number unknown[k], which no point has. */
typedef struct tetproof_document_arrays {
  const char* format;    /* "msh41", "tetgen", ...; empty: no file was read */
  int64_t element_count; /* of all shapes */
  int64_t point_count;
  const double* points;         /* x y z of each [length] */
  const int64_t* point_numbers; /* in the file */
  int64_t tet_count;
  const int32_t* tets; /* four positions in `points` of each */
  const int64_t* tet_numbers;
  const int64_t* tet_groups;   /* the first physical group (attribute, reference) of each; 0: none */
  const int64_t* tet_entities; /* the entity of the geometry; 0: none */
  int64_t triangle_count;
  const int32_t* triangles; /* three positions in `points` of each */
  const int64_t* triangle_numbers;
  const int64_t* triangle_groups;
  const int64_t* triangle_entities;
  int64_t unknown_count;
  const int64_t* unknown;
  int64_t group_count; /* those that have names */
  const tetproof_group* const* groups;
} tetproof_document_arrays;

/* The arrays, which are made at the first call. They belong to the document, and are valid until it is
 * freed or changed. */
TETPROOF_API tetproof_status tetproof_document_view(const tetproof_document* document,
                                                    const tetproof_document_arrays** arrays,
                                                    tetproof_error* error);

/* A JSON object that describes what the document holds: the object `input` of `tetproof-convert --info
 * --json`, and with it `warnings` and `dropped`, as tetproof_surface_json has them. */
TETPROOF_API tetproof_status tetproof_document_json(const tetproof_document* document, char** json,
                                                    tetproof_error* error);

enum { TETPROOF_ENCODING_DEFAULT = 0, TETPROOF_ENCODING_TEXT = 1, TETPROOF_ENCODING_BINARY = 2 };
enum {
  TETPROOF_STRICT_OFF = 0,
  TETPROOF_STRICT_ON = 1,    /* nothing may be lost, in reading or in writing */
  TETPROOF_STRICT_NATIVE = 2 /* nor kept where only our reader finds it */
};

typedef struct tetproof_write_options {
  size_t size;        /* set by tetproof_write_options_init */
  const char* format; /* "msh41", "msh22", "vtu", ...; null: the path's ending decides */
  int32_t encoding;   /* TETPROOF_ENCODING_... */
  int32_t strict;     /* TETPROOF_STRICT_... */
} tetproof_write_options;

/* Sets the defaults. `size`: sizeof(tetproof_write_options). BAD_ARGUMENT: another size. */
TETPROOF_API tetproof_status tetproof_write_options_init(tetproof_write_options* options, size_t size,
                                                         tetproof_error* error);

/* Says what tetproof_document_write with these arguments would lose, and writes nothing. A JSON object:
 * `dropped` (not read), `losses` (the format has no place for it), `kept_aside` (only our reader finds it
 * again), `dangling` (elements that name nodes which do not exist), each an array of objects with `item`,
 * `count` and `example`; and `warning`, a text, empty for none. BAD_INPUT: the ending is unknown, or the
 * format cannot be written in this encoding. */
TETPROOF_API tetproof_status tetproof_document_losses(const tetproof_document* document, const char* path,
                                                      const tetproof_write_options* options, char** json,
                                                      tetproof_error* error);

/* Writes the document whole or not at all. What the format cannot hold is left out; with `strict` that is
 * LOSSY, and nothing is written. `options`: null for the defaults. BAD_INPUT: the place cannot be written. */
TETPROOF_API tetproof_status tetproof_document_write(const tetproof_document* document, const char* path,
                                                     const tetproof_write_options* options,
                                                     tetproof_error* error);

/* --- Grids by the paper's method ---------------------------------------------------------------------- */

enum { TETPROOF_DIAGONALS_LOWEST = 0, TETPROOF_DIAGONALS_SHORTEST = 1 };
enum { TETPROOF_IMPROVE_SOLID_ANGLE = 0, TETPROOF_IMPROVE_ASPECT_RATIO = 1, TETPROOF_IMPROVE_NONE = 2 };
/* For `points`: insert until no split lowers the mean error. */
#define TETPROOF_POINTS_AUTO (-1)

/* The options of tetproof-mesh, with the same defaults; its --help explains each. */
typedef struct tetproof_mesh_options {
  size_t size;       /* set by tetproof_mesh_options_init */
  int32_t region;    /* TETPROOF_REGION_INSIDE [default] or _OUTSIDE */
  int32_t cells[3];  /* lattice cells along x, y, z; {n, 0, 0}: along the longest side; {0, 0, 0}: 24, or more
                        where the surface is so thin that the grid would be empty [{0, 0, 0}] */
  double box_scale;  /* the lattice's box over the surface's box, more than 1 [1.2] */
  double on_surface; /* lattice vertices nearer than this move onto the surface [shortest cell edges, 0 to
                        0.15] [1e-6] */
  int32_t diagonals; /* TETPROOF_DIAGONALS_... */
  int32_t literal;   /* as printed in the paper [0] */
  int32_t parametric; /* follow the surface's parametric definition if it has one [1] */
  int32_t threads;    /* at most so many, 1 to 4096; 0: all processors [0] */
  int64_t points; /* the largest number of points to insert; 0: the first grid; TETPROOF_POINTS_AUTO [auto] */
  double v0, v1;  /* eq. (3.1): volumes at distance 0 and d1, in mean volumes of the first grid [0.2, 2] */
  double e_avg;   /* stop when the mean error is not larger than this, in the unit of v0; 0: never [0] */
  int32_t v0_is_absolute, v1_is_absolute, e_avg_is_absolute; /* these are volumes [length^3] [0] */
  int32_t curvature;     /* weight the distance by curvature, eq. (3.6) [0] */
  double d1;             /* eq. (3.1): a distance [length]; 0: the largest of the first grid [0] */
  double p;              /* eq. (3.1): the exponent, more than 0 [1] */
  double improve_below;  /* improve after an insertion that made a solid angle smaller [4 pi] [0.002] */
  double deadline;       /* seconds after which the call gives up with OUT_OF_TIME, which it looks at between
                            its steps and after each insertion; 0: none [0] */
  int32_t improve;       /* TETPROOF_IMPROVE_...: the measure that flips raise */
  int32_t past_dilution; /* go on even if the chosen tetrahedron is not larger than it should be; needs a
                            number of points [0] */
} tetproof_mesh_options;

/* Sets the defaults. `size`: sizeof(tetproof_mesh_options). BAD_ARGUMENT: another size. */
TETPROOF_API tetproof_status tetproof_mesh_options_init(tetproof_mesh_options* options, size_t size,
                                                        tetproof_error* error);

/* Fills a closed surface, or the space around it, with tetrahedra by the method of Hamann, Chen and Hong
 * (1994). The grid is that of tetproof-mesh. It is not judged: tetproof_judge_document does. `options`: null
 * for the defaults. BAD_INPUT: the surface is not usable. A surface that is thinner than the lattice
 * everywhere gives a document without tetrahedra. */
TETPROOF_API tetproof_status tetproof_mesh(const tetproof_surface* surface,
                                           const tetproof_mesh_options* options, tetproof_document** document,
                                           tetproof_error* error);

#ifdef __cplusplus
}
#endif

#endif
