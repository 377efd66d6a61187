"""Parts of the C++ program over a cluster by dask, from the top folder of a clone."""

import subprocess

from distributed import Client, LocalCluster

program = "build/examples/examples/07_experiments"


# A part
def part(first: int) -> None:
    numbers = ["--first", str(first), "--last", str(first + 99)]
    subprocess.run([program, *numbers, "--output", "parts"], check=True)


if __name__ == "__main__":
    # Five lines of dask; in earnest Client("scheduler:8786")
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None)
    with cluster, Client(cluster) as client:
        client.gather(client.map(part, range(0, 300, 100)))
    files = [f"parts/experiments_{first}_{first + 99}.csv" for first in range(0, 300, 100)]
    subprocess.run([program, "--first", "0", "--last", "299", "--merge", *files], check=True)
