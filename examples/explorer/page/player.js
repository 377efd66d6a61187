// A log that is played again: its lines go by in their own time, as the rows of a simulation do.

import {make_tracks} from './tracks.js';

// log: of the engine's open_log(); law: the id of the law that it went through.
export function make_player(log, law) {
  const count = log.count(),
    time_at = log.layout.values.find(entry => entry.id === 't').offset,
    start = log.row(0)[time_at];
  const player = {
    tracks: make_tracks(log.layout, [law]),
    count,
    line: 0,
    clock: 0,
    is_ended: count === 0,
    // Goes on by so many seconds.
    advance(seconds) {
      player.clock += seconds;
      while (player.line < count) {
        const row = log.row(player.line);
        if (row[time_at] - start > player.clock) return;
        player.tracks.add(0, row);
        ++player.line;
      }
      player.is_ended = true;
    },
    restart() {
      Object.assign(player, {tracks: make_tracks(log.layout, [law]), line: 0, clock: 0, is_ended: false});
    },
    end: () => log.end(),
  };
  return player;
}
