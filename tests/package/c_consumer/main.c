/* SPDX-License-Identifier: GPL-3.0-or-later
 * A user's program in C: cuts a grid from a generated surface, writes and reads it, has it judged, and has a
 * broken one judged too. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tetproof.h>

static tetproof_error error;

static int failed(const char* what) {
  fprintf(stderr, "%s: %s\n", what, error.message);
  return 1;
}

int main(void) {
  if (strcmp(tetproof_version(), TETPROOF_VERSION_STRING) != 0) return failed("another version is loaded");

  tetproof_surface* torus = NULL;
  if (tetproof_surface_open("torus:R=1,r=0.4,n=2000", NULL, &torus, &error)) return failed("surface");
  tetproof_mesh_options cells;
  tetproof_mesh_options_init(&cells, sizeof cells, NULL);
  cells.cells[0] = 16;
  cells.points = 0;
  tetproof_document *grid = NULL, *back = NULL;
  if (tetproof_mesh(torus, &cells, &grid, &error)) return failed("mesh");
  if (tetproof_document_write(grid, "torus.msh", NULL, &error)) return failed("write");
  if (tetproof_document_read("torus.msh", NULL, &back, &error)) return failed("read");

  tetproof_judge_options options;
  tetproof_judge_options_init(&options, sizeof options, NULL);
  options.fidelity = 0.1;
  options.voxels = 32;
  tetproof_report* report = NULL;
  if (tetproof_judge_document(back, torus, &options, &report, &error)) return failed("judge");
  const tetproof_records* records = tetproof_report_records(report);
  if (records->verdict != TETPROOF_SOUND || records->mesh->genus != 1) return failed("not a sound torus");
  tetproof_report_free(report);

  const tetproof_document_arrays* arrays = NULL;
  if (tetproof_document_view(back, &arrays, &error)) return failed("arrays");
  const size_t bytes = (size_t)arrays->tet_count * 4 * sizeof(int32_t);
  int32_t* const tets = malloc(bytes);
  if (!tets) return failed("no memory");
  memcpy(tets, arrays->tets, bytes);
  tets[0] = arrays->tets[1], tets[1] = arrays->tets[0];
  const tetproof_points points = {arrays->points, arrays->point_count, 0, 0};
  const tetproof_integers broken = {tets, arrays->tet_count, 0, 0, 0, 32};
  if (tetproof_judge(&points, &broken, NULL, NULL, NULL, &report, &error)) return failed("judge arrays");
  const int seen = tetproof_report_records(report)->verdict == TETPROOF_DEFECTIVE;

  tetproof_report_free(report);
  free(tets);
  tetproof_document_free(back);
  tetproof_document_free(grid);
  tetproof_surface_free(torus);
  return seen ? 0 : failed("an inverted tetrahedron went unseen");
}
