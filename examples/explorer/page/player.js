// A log that is played again: its lines go by in their own time, as the rows of a simulation do.

import {make_tracks, row_length} from './tracks.js';

// rows: of this layout, one after the other; law: the id of the law that they went through.
export function make_player(layout, rows, law) {
  const width = row_length(layout),
    count = rows.length / width,
    time_of = line => rows[line * width + layout.find(entry => entry.id === 't').offset];
  const player = {
    count,
    // Goes on by so many seconds.
    advance(seconds) {
      player.clock += seconds;
      const from = player.line;
      while (player.line < count && time_of(player.line) - time_of(0) <= player.clock) ++player.line;
      player.tracks.add(0, rows.subarray(from * width, player.line * width));
      player.is_ended = player.line === count;
    },
    restart() {
      Object.assign(player, {tracks: make_tracks(layout, [law]), line: 0, clock: 0, is_ended: count === 0});
    },
  };
  player.restart();
  return player;
}
