/** The store on a given table of system calls; exk_store_save and _load are these on the system's own. */
#ifndef EXK_STORE_ON_H
#define EXK_STORE_ON_H

#include "exk/store.h"
#include "store_os.h"

exk_store_err store_save_on(const store_os *os, const char *path, const exk_store *store,
                            char *why, size_t why_size);
exk_store_err store_load_on(const store_os *os, const char *path, exk_store *store, char *why,
                            size_t why_size);

#endif
