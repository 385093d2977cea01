/* SPDX-License-Identifier: GPL-3.0-or-later
 * Calls every function of the header from C99, once as it should be and once with nothing but null pointers,
 * and is silent. Compiled with -pedantic-errors, so that the header is C99 and no more. */
#include <stdint.h>
#include <string.h>

#include "tetproof.h"
#include "tetproof.h" /* may be included twice */

/* Sizes that callers have compiled in: a change of one breaks them. */
typedef char points_are_fixed[sizeof(tetproof_points) == 24 + sizeof(void*) ? 1 : -1];
typedef char integers_are_fixed[sizeof(tetproof_integers) == 40 + sizeof(void*) ? 1 : -1];
typedef char errors_are_fixed[sizeof(tetproof_error) == 1024 ? 1 : -1];

#define EXPECT(condition) \
  if (!(condition)) return __LINE__

int main(void) {
  tetproof_error error;
  EXPECT(strcmp(tetproof_version(), TETPROOF_VERSION_STRING) == 0);
  EXPECT(strcmp(tetproof_status_name(TETPROOF_LOSSY), "TETPROOF_LOSSY") == 0);

  tetproof_surface* sphere = NULL;
  EXPECT(tetproof_surface_open("sphere:r=1,n=200", NULL, &sphere, &error) == TETPROOF_OK);
  EXPECT(error.status == TETPROOF_OK && error.message[0] == 0);
  char* text = NULL;
  EXPECT(tetproof_surface_fault(sphere, &text, NULL) == TETPROOF_OK && text == NULL);
  EXPECT(tetproof_surface_json(sphere, &text, NULL) == TETPROOF_OK);
  tetproof_text_free(text);
  EXPECT(tetproof_list_surfaces(&text, NULL) == TETPROOF_OK && strstr(text, "sphere") != NULL);
  tetproof_text_free(text);

  tetproof_mesh_options cut;
  EXPECT(tetproof_mesh_options_init(&cut, sizeof cut, NULL) == TETPROOF_OK);
  cut.cells[0] = 6;
  cut.points = 0;
  tetproof_document* grid = NULL;
  EXPECT(tetproof_mesh(sphere, &cut, &grid, &error) == TETPROOF_OK);
  const tetproof_document_arrays* a = NULL;
  EXPECT(tetproof_document_view(grid, &a, &error) == TETPROOF_OK && a->tet_count > 50);

  tetproof_judge_options judge;
  EXPECT(tetproof_judge_options_init(&judge, sizeof judge, NULL) == TETPROOF_OK);
  judge.fidelity = 0.2;
  judge.voxels = 16;
  judge.threads = 4096; /* more than there are, which oneTBB would remark on */
  const tetproof_points points = {a->points, a->point_count, 0, 0};
  const tetproof_integers tets = {a->tets, a->tet_count, 0, 0, 0, 32};
  tetproof_report* report = NULL;
  EXPECT(tetproof_judge(&points, &tets, NULL, sphere, &judge, &report, &error) == TETPROOF_OK);
  const tetproof_records* r = tetproof_report_records(report);
  EXPECT(r->verdict == TETPROOF_SOUND && r->certificate == 1 && r->mesh->tets == a->tet_count);
  EXPECT(r->check_count > 0 && strcmp(r->checks[0]->id, tetproof_check_info_at(0)->id) == 0);
  tetproof_report* again = NULL;
  EXPECT(tetproof_judge_document(grid, NULL, NULL, &again, NULL) == TETPROOF_OK);
  EXPECT(tetproof_report_records(again)->verdict == TETPROOF_SOUND);
  EXPECT(tetproof_report_json(report, &text, NULL) == TETPROOF_OK && text[0] == '{');
  tetproof_text_free(text);
  tetproof_document* defects = NULL;
  EXPECT(tetproof_report_defects(report, &points, &tets, &defects, &error) == TETPROOF_OK);
  tetproof_document_free(defects);
  EXPECT(tetproof_report_document_defects(again, grid, &defects, &error) == TETPROOF_OK);
  tetproof_document_free(defects);
  EXPECT(tetproof_report_text(report, &text, NULL) == TETPROOF_OK);
  tetproof_text_free(text);
  EXPECT(tetproof_report_junit(report, "mesh", &text, NULL) == TETPROOF_OK && text[0] == '<');
  tetproof_text_free(text);
  EXPECT(tetproof_report_html(report, &points, &tets, sphere, "mesh", &text, NULL) == TETPROOF_OK);
  EXPECT(strstr(text, "<!DOCTYPE html>") == text);
  tetproof_text_free(text);
  EXPECT(tetproof_report_document_html(again, grid, NULL, "mesh", &text, NULL) == TETPROOF_OK);
  tetproof_text_free(text);

  tetproof_write_options write;
  EXPECT(tetproof_write_options_init(&write, sizeof write, NULL) == TETPROOF_OK);
  EXPECT(tetproof_document_losses(grid, "grid.stl", &write, &text, NULL) == TETPROOF_OK);
  EXPECT(strstr(text, "tetrahedra") != NULL);
  tetproof_text_free(text);
  write.strict = TETPROOF_STRICT_ON;
  EXPECT(tetproof_document_write(grid, "grid.stl", &write, &error) == TETPROOF_LOSSY);
  EXPECT(tetproof_document_name_group(grid, 3, 1, "ball", NULL) == TETPROOF_OK);
  EXPECT(tetproof_document_json(grid, &text, NULL) == TETPROOF_OK && strstr(text, "ball") != NULL);
  tetproof_text_free(text);
  const char* const off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  tetproof_document* read = NULL;
  tetproof_surface* surface = NULL;
  EXPECT(tetproof_document_read_memory(off, strlen(off), NULL, &read, &error) == TETPROOF_OK);
  EXPECT(tetproof_surface_from_document(read, &surface, &error) == TETPROOF_OK);
  EXPECT(tetproof_surface_view(surface)->triangle_count == 4);
  tetproof_surface_free(surface);
  tetproof_document_free(read);
  tetproof_report_free(again);
  tetproof_report_free(report);
  tetproof_document_free(grid);
  tetproof_surface_free(sphere);

  /* Nothing at all: refused, or nothing to do. */
  const int32_t bad = TETPROOF_BAD_ARGUMENT;
  EXPECT(tetproof_surface_from_arrays(NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_surface_open(NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_surface_from_document(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_surface_view(NULL) == NULL);
  EXPECT(tetproof_surface_fault(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_surface_json(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_list_surfaces(NULL, NULL) == bad);
  EXPECT(tetproof_judge_options_init(NULL, 0, NULL) == bad);
  EXPECT(tetproof_judge(NULL, NULL, NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_judge_document(NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_json(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_text(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_junit(NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_html(NULL, NULL, NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_document_html(NULL, NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_records(NULL) == NULL);
  EXPECT(tetproof_report_defects(NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_report_document_defects(NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_check_info_at(-1) == NULL && tetproof_check_info_at(1000) == NULL);
  EXPECT(tetproof_document_read(NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_document_read_memory(NULL, 0, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_document_from_arrays(NULL, NULL, NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_document_name_group(NULL, 0, 0, NULL, NULL) == bad);
  EXPECT(tetproof_document_view(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_document_json(NULL, NULL, NULL) == bad);
  EXPECT(tetproof_write_options_init(NULL, 0, NULL) == bad);
  EXPECT(tetproof_document_losses(NULL, NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_document_write(NULL, NULL, NULL, NULL) == bad);
  EXPECT(tetproof_mesh_options_init(NULL, 0, NULL) == bad);
  EXPECT(tetproof_mesh(NULL, NULL, NULL, NULL) == bad);
  tetproof_surface_free(NULL);
  tetproof_document_free(NULL);
  tetproof_report_free(NULL);
  tetproof_text_free(NULL);
  return 0;
}
