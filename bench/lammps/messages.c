/* SPDX-License-Identifier: MIT
 * Counts what processes send by MPI: loaded in front of its library (LD_PRELOAD), it writes for each process how many messages
 * to others and how many bytes it sent between points, and how many collective operations it took part in. */
#include <mpi.h>
#include <stdio.h>

static long messages, bytes, collectives;

static void count(int items, MPI_Datatype type, int destination, MPI_Comm comm) {
  int size = 0, rank = 0;
  PMPI_Type_size(type, &size);
  PMPI_Comm_rank(comm, &rank);
  if (destination == rank || destination == MPI_PROC_NULL) return;
  ++messages;
  bytes += (long)size * items;
}

int MPI_Send(const void* data, int items, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  count(items, type, to, comm);
  return PMPI_Send(data, items, type, to, tag, comm);
}

int MPI_Rsend(const void* data, int items, MPI_Datatype type, int to, int tag, MPI_Comm comm) {
  count(items, type, to, comm);
  return PMPI_Rsend(data, items, type, to, tag, comm);
}

int MPI_Isend(const void* data, int items, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  count(items, type, to, comm);
  return PMPI_Isend(data, items, type, to, tag, comm, request);
}

int MPI_Sendrecv(const void* data, int items, MPI_Datatype type, int to, int tag, void* received, int most, MPI_Datatype kind,
                 int from, int other, MPI_Comm comm, MPI_Status* status) {
  count(items, type, to, comm);
  return PMPI_Sendrecv(data, items, type, to, tag, received, most, kind, from, other, comm, status);
}

int MPI_Allreduce(const void* data, void* result, int items, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  ++collectives;
  return PMPI_Allreduce(data, result, items, type, op, comm);
}

int MPI_Finalize(void) {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  fprintf(stderr, "sent rank %d messages %ld bytes %ld collectives %ld\n", rank, messages, bytes, collectives);
  return PMPI_Finalize();
}
