/** \file
 * Of leadscrew.h: tools, surfaces that a program machines, where tools gouge them, and contours beside which tools go.
 */
#ifndef LEADSCREW_SURFACES_H
#define LEADSCREW_SURFACES_H

#include "leadscrew_base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

/** A tool of a table, as a body. */
typedef struct leadscrew_tool {
  size_t size;      /**< of this structure, sizeof */
  int32_t number;   /**< T, > 0 */
  int32_t reserved; /**< 0 */
  double diameter;  /**< mm; 0: not told */
  double
      corner_radius; /**< of its round edge, mm: 0 flat, half the diameter a ball; -1: nothing is told of its shape */
  double length;     /**< from the tip to the holder, mm; 0: not told */
  double holder_diameter; /**< mm; 0: there is none */
  double holder_length;   /**< mm */
} leadscrew_tool;
/** Called once for each tool, in the order of the table. */
typedef void (*leadscrew_tool_function)(const leadscrew_tool* tool, void* user);

/** A surface that a program machines, as quadrilaterals in the workpiece as it lies with all rotary axes at 0. */
typedef struct leadscrew_surface {
  size_t size;      /**< of this structure, sizeof */
  int32_t number;   /**< D */
  int32_t reserved; /**< 0 */
  size_t
      cells; /**< quadrilaterals; two triangles each, of corners 0 1 2 and 0 2 3, lie within the sag of the surface */
  const double* corners; /**< cells * 12: X, Y and Z of four corners, mm; valid until the function returns */
  const double* normals; /**< cells * 12: of the surface there, unit vectors; 0 0 0 where it has none; likewise */
} leadscrew_surface;
/** Called once for each surface that differs from those before. */
typedef void (*leadscrew_surface_function)(const leadscrew_surface* surface, void* user);

/** Parts of a tool. */
enum { LEADSCREW_CUTTER = 0, LEADSCREW_SHANK = 1, LEADSCREW_HOLDER = 2 };

/** Where a tool cuts more than it should of a surface that a program machines. */
typedef struct leadscrew_gouge {
  size_t size;       /**< of this structure, sizeof */
  int64_t line;      /**< of the program */
  int32_t file;      /**< as a word's */
  int32_t part;      /**< of the move: as a block's */
  int32_t pass;      /**< as a block's */
  int32_t tool_part; /**< LEADSCREW_CUTTER … LEADSCREW_HOLDER */
  int32_t surface;   /**< D of the one that is cut */
  int32_t reserved;  /**< 0 */
  double
      depth; /**< mm, of the deepest place of this block, part and pass; 0: the tool bends less than the surface that it
                          touches, and how deep it is beside is not told */
  double clearance;    /**< 1/mm, where the depth is 0: < 0, curvature of the tool less that of the surface */
  double u;            /**< its place, a parameter of the surface */
  double v;            /**< the other */
  double place[3];     /**< the same in the workpiece, mm */
  double tip[3];       /**< of the tool there, mm; of depth 0 the place */
  double direction[3]; /**< the same, a unit vector; of depth 0 all 0 */
} leadscrew_gouge;
/** Called once for each block, part and pass that gouges, in their order, and then for each block that does so where it touches. */
typedef void (*leadscrew_gouge_function)(const leadscrew_gouge* gouge, void* user);

/** A line or an arc of a program while cutter compensation (G41, G42) leads the tool beside it, as the program tells it: in the
 * workpiece as it lies with all rotary axes at 0, where the tip would go without. */
typedef struct leadscrew_contour {
  size_t size;          /**< of this structure, sizeof */
  int64_t line;         /**< of the program */
  int32_t file;         /**< as a word's */
  int32_t is_rapid;     /**< 1: G0 */
  size_t count;         /**< places, > 1; chords between them lie within the sag */
  const double* places; /**< count * 3: X, Y and Z, mm; valid until the function returns */
} leadscrew_contour;
/** Called once for each, in the order of motion: the way in, the contour, the way out. */
typedef void (*leadscrew_contour_function)(const leadscrew_contour* contour, void* user);

/** The tools of options->tools or options->tools_file. `user` is for the function. */
LEADSCREW_API int leadscrew_tools(const leadscrew_options* options, leadscrew_tool_function on_tool, void* user,
                                  leadscrew_error* error);
/** The surfaces that a sound program machines (G6.5); triangles lie within `sag` of them, mm, > 0, or as near as a million of
 * them allow. LEADSCREW_REJECTED with the program's first error, and of more than 1000 surfaces. `options` may be NULL; `user` is
 * for the function. */
LEADSCREW_API int leadscrew_program_surfaces(const leadscrew_machine* machine, const char* text, size_t length,
                                             const leadscrew_options* options, double sag,
                                             leadscrew_surface_function on_surface, void* user, leadscrew_error* error);
/** Where a program gouges surfaces that it machines by more than `tolerance`, mm, > 0, at most 1000 of each kind: as
 * `leadscrew check --gouge` does. That gouging is allowed for the reading: it is told here. Errors as above. */
LEADSCREW_API int leadscrew_program_gouges(const leadscrew_machine* machine, const char* text, size_t length,
                                           const leadscrew_options* options, double tolerance,
                                           leadscrew_gouge_function on_gouge, void* user, leadscrew_error* error);

/** What a sound program tells where cutter compensation is on, apart from the motion of the tool's middle that becomes of it: nothing
 * of a program without G41 and G42. Chords lie within `sag` of it, mm, > 0, or are 8192nd parts of a radian. Errors as above. */
LEADSCREW_API int leadscrew_program_contours(const leadscrew_machine* machine, const char* text, size_t length,
                                             const leadscrew_options* options, double sag,
                                             leadscrew_contour_function on_contour, void* user, leadscrew_error* error);

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
