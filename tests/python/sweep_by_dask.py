"""A sweep over two workers of dask, one of which is killed in the middle: python sweep_by_dask.py COUNT."""

import os
import sys

import experiments
from distributed import Client, LocalCluster

from passive_haptics.sweep import sweep

if __name__ == "__main__":
    cluster = LocalCluster(
        n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None, worker_dashboard_address=None
    )
    with cluster, Client(cluster) as client:
        results = sweep(experiments.dies_once, range(int(sys.argv[1])), client.get_executor())
        experiments.print_digest(results)
    assert os.path.exists(os.environ["SWEEP_KILLED"]), "no worker was killed"
