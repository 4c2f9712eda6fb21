/** Ranks of an mpirun: rank r runs the blocks r, r + size, ...; rank 0 collects the records.
 *
 *  Without MPI built in, or when not started by mpirun, there is one rank, 0.
 *  Errors  gather returns the worst exit code of all ranks on rank 0 and STUDY_NOT_ROOT on others.
 */
#ifndef STUDY_MPI_RANKS_H
#define STUDY_MPI_RANKS_H

#include "blocks.h"

enum { STUDY_NOT_ROOT = -1 };

void study_mpi_begin(void);
void study_mpi_end(void);
int study_mpi_rank(void);
int study_mpi_size(void);
int study_mpi_gather(study_blocks *blocks, int code);

#endif
