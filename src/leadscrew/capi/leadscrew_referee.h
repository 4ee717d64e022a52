/** \file
 * Of leadscrew.h: the referee, who judges words by the program that they were made for, and shares no code with what makes them.
 */
#ifndef LEADSCREW_REFEREE_H
#define LEADSCREW_REFEREE_H

#include "leadscrew_base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* C has its own style of names, and its enumerations are int. NOLINTBEGIN(readability-identifier-naming,performance-enum-size) */

typedef struct leadscrew_referee leadscrew_referee; /**< judges the words of one motion along one program */

/** How far a word is from the path that is programmed, with which words are matched in order. */
typedef struct leadscrew_judged {
  size_t size; /**< of this structure, sizeof */
  double
      distance; /**< mm, from the place of the path that the word is matched to, of several the nearest; of the tool's tip
                        under tool centre point control */
  double tolerance; /**< mm, of the block there: P of G64, or the machine's; 0 under G61 and G61.1 */
  int64_t line;     /**< of that block */
  int32_t file;     /**< as a word's */
  int32_t visit;    /**< as a word's */
} leadscrew_judged;

/** Of all words of a motion, as `leadscrew verify` has it. */
typedef struct leadscrew_verdict {
  size_t size;      /**< of this structure, sizeof */
  double deviation; /**< mm, the largest distance between words and program, of either from the other: at a corner that
                            is rounded that of the corner */
  double tolerance; /**< mm, the largest that applied */
  double start_error; /**< mm, of the first word from where the program begins */
  double end_error;   /**< mm, of the last word from where it ends */
  int64_t objections; /**< to words that keep a limit or a tolerance not */
} leadscrew_verdict;

/** Before the first word of a motion along this program, with these options, which may be NULL; their functions are called while
 * words are observed. Memory does not grow with the words. */
LEADSCREW_API int leadscrew_referee_begin(const leadscrew_machine* machine, const char* text, size_t length,
                                          const leadscrew_options* options, leadscrew_referee** referee,
                                          leadscrew_error* error);
/** The next word, a period after the one before; `word_size` is sizeof(leadscrew_word). Its position and feed are read; a feed
 * below 0: it is not told. `judged` may be NULL. LEADSCREW_REJECTED once the program, as far as it has been read, has an error;
 * LEADSCREW_INTERRUPTED where on_progress said so. */
LEADSCREW_API int leadscrew_referee_observe(leadscrew_referee* referee, const leadscrew_word* word, size_t word_size,
                                            leadscrew_judged* judged, leadscrew_error* error);
/** After the last word; no other may follow, and it is asked once. Errors as of leadscrew_referee_observe(). */
LEADSCREW_API int leadscrew_referee_conclude(leadscrew_referee* referee, leadscrew_verdict* verdict,
                                             leadscrew_error* error);
/** It may be NULL. */
LEADSCREW_API void leadscrew_referee_free(leadscrew_referee* referee);

/* NOLINTEND(readability-identifier-naming,performance-enum-size) */

#ifdef __cplusplus
}
#endif
#endif
