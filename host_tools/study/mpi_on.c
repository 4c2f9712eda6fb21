#include <mpi.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "mpi_ranks.h"

enum { WHY_SIZE = 256, TAG = 1 };

/* MPI_Init costs a third of a second, and a lone process has nobody to talk to. */
static bool started_by_mpirun(void)
{
    static const char *const names[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (getenv(names[i]) != NULL) {
            return true;
        }
    }
    return false;
}

static bool is_on(void)
{
    int on = 0;
    int ended = 0;
    MPI_Initialized(&on);
    MPI_Finalized(&ended);
    return on && !ended;
}

void study_mpi_begin(void)
{
    int level = 0;
    if (started_by_mpirun()) {
        MPI_Init_thread(NULL, NULL, MPI_THREAD_FUNNELED, &level);
    }
}

void study_mpi_end(void)
{
    if (is_on()) {
        MPI_Finalize();
    }
}

int study_mpi_rank(void)
{
    int rank = 0;
    if (is_on()) {
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    }
    return rank;
}

int study_mpi_size(void)
{
    int size = 1;
    if (is_on()) {
        MPI_Comm_size(MPI_COMM_WORLD, &size);
    }
    return size;
}

/* Exit code first, then each record of this rank's blocks, an empty one for what was not run. */
static void send_all(const study_blocks *blocks, int rank, int size, int code)
{
    MPI_Send(&code, 1, MPI_INT, 0, TAG, MPI_COMM_WORLD);
    for (size_t i = (size_t)rank; i < blocks->n_blocks; i += (size_t)size) {
        const study_record *record = &blocks->records[i];
        MPI_Send(record->bytes, (int)record->n_bytes, MPI_BYTE, 0, TAG, MPI_COMM_WORLD);
    }
}

static int receive_record(study_blocks *blocks, size_t i, int rank)
{
    MPI_Status status;
    int n = 0;
    char why[WHY_SIZE] = "out of memory";
    MPI_Probe(rank, TAG, MPI_COMM_WORLD, &status);
    MPI_Get_count(&status, MPI_BYTE, &n);
    uint8_t *bytes = malloc((size_t)n + 1);
    if (bytes == NULL) {
        MPI_Abort(MPI_COMM_WORLD, STUDY_IO);
        return STUDY_IO;
    }
    MPI_Recv(bytes, n, MPI_BYTE, rank, TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (n == 0 || blocks->records[i].bytes != NULL) {
        free(bytes);
        return STUDY_GOOD;
    }
    if (!study_blocks_take(blocks, bytes, (size_t)n, why, sizeof why)) {
        fprintf(stderr, "exk-study: block %zu of rank %d is refused: %s\n", i, rank, why);
        return STUDY_IO;
    }
    return STUDY_GOOD;
}

static int receive_all(study_blocks *blocks, int rank, int size)
{
    int worst = STUDY_GOOD;
    MPI_Recv(&worst, 1, MPI_INT, rank, TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    for (size_t i = (size_t)rank; i < blocks->n_blocks; i += (size_t)size) {
        const int code = receive_record(blocks, i, rank);
        worst = code > worst ? code : worst;
    }
    return worst;
}

int study_mpi_gather(study_blocks *blocks, int code)
{
    const int rank = study_mpi_rank();
    const int size = study_mpi_size();
    if (rank > 0) {
        send_all(blocks, rank, size, code);
        return STUDY_NOT_ROOT;
    }
    for (int other = 1; other < size; other++) {
        const int theirs = receive_all(blocks, other, size);
        code = theirs > code ? theirs : code;
    }
    return code;
}
