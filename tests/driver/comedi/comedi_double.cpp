// The functions of libcomedi that a port calls. Transfers allocate nothing, as those of libcomedi.
#include "comedi_double.hpp"

#include <cerrno>
#include <cmath>
#include <cstring>

struct comedi_t_struct {};

namespace {

using comedi_double::plugged;
using comedi_double::subdevice;

comedi_t_struct the_handle;
int last_error = 0;

int failed(int error) {
  last_error = error;
  return -1;
}

subdevice* find(unsigned index) {
  return index < plugged.subdevices.size() ? &plugged.subdevices[index] : nullptr;
}

int transfer(comedi_insn& instruction) {
  subdevice* s = find(instruction.subdev);
  const unsigned channel = CR_CHAN(instruction.chanspec);
  if (plugged.transfer_error != 0) return failed(plugged.transfer_error);
  if (s == nullptr || channel >= static_cast<unsigned>(s->channels)) return failed(EINVAL);
  if (s->broken[channel]) return failed(EIO);
  if (instruction.insn == INSN_READ) instruction.data[0] = s->value[channel];
  if (instruction.insn == INSN_WRITE) {
    s->value[channel] = instruction.data[0];
    ++s->writes[channel];
  }
  s->last_reference = CR_AREF(instruction.chanspec);
  return 1;
}

int set_up(unsigned index, const std::string& call) {
  if (plugged.refuses_set_up) return failed(EINVAL);
  plugged.subdevices[index].set_up.push_back(call);
  return 0;
}

}  // namespace

extern "C" {

comedi_t* comedi_open(const char* file) {
  const int error = plugged.open_error != 0 ? plugged.open_error : file != plugged.file ? ENOENT : 0;
  if (error != 0) return failed(error), nullptr;
  ++plugged.handles;
  return &the_handle;
}
int comedi_close(comedi_t*) { return --plugged.handles, 0; }
int comedi_errno() { return last_error; }
const char* comedi_strerror(int error) { return std::strerror(error); }
const char* comedi_get_board_name(comedi_t*) { return "double"; }

int comedi_get_n_subdevices(comedi_t*) { return static_cast<int>(plugged.subdevices.size()); }
int comedi_get_subdevice_type(comedi_t*, unsigned s) { return find(s) ? find(s)->type : failed(EINVAL); }
int comedi_get_subdevice_flags(comedi_t*, unsigned s) {
  return find(s) ? static_cast<int>(find(s)->flags) : failed(EINVAL);
}
int comedi_get_n_channels(comedi_t*, unsigned s) { return find(s) ? find(s)->channels : failed(EINVAL); }
lsampl_t comedi_get_maxdata(comedi_t*, unsigned s, unsigned) { return find(s) ? find(s)->max_sample : 0; }
int comedi_get_n_ranges(comedi_t*, unsigned s, unsigned) { return static_cast<int>(find(s)->ranges.size()); }
comedi_range* comedi_get_range(comedi_t*, unsigned s, unsigned, unsigned range) {
  return find(s) && range < find(s)->ranges.size() ? &find(s)->ranges[range] : nullptr;
}
int comedi_find_subdevice_by_type(comedi_t*, int type, unsigned first) {
  for (unsigned i = first; i < plugged.subdevices.size(); ++i)
    if (plugged.subdevices[i].type == type) return static_cast<int>(i);
  return -1;
}
lsampl_t comedi_from_phys(double volts, comedi_range* r, lsampl_t max_sample) {
  const double sample = std::floor((volts - r->min) / (r->max - r->min) * max_sample + 0.5);
  return sample <= 0 ? 0 : sample >= max_sample ? max_sample : static_cast<lsampl_t>(sample);
}

int comedi_do_insn(comedi_t*, comedi_insn* instruction) { return transfer(*instruction); }
int comedi_do_insnlist(comedi_t*, comedi_insnlist* list) {
  ++plugged.lists;
  const int wanted = static_cast<int>(list->n_insns);
  for (int i = 0; i < wanted; ++i) {
    if (i == plugged.served) return i;
    if (transfer(list->insns[i]) != 1) return -1;
  }
  return wanted;
}
int comedi_data_write(comedi_t*, unsigned s, unsigned channel, unsigned, unsigned, lsampl_t data) {
  comedi_insn instruction{INSN_WRITE, 1, &data, s, CR_PACK(channel, 0, 0), {}};
  return transfer(instruction);
}

int comedi_reset(comedi_t*, unsigned s) { return set_up(s, "reset"); }
int comedi_arm(comedi_t*, unsigned s, unsigned) { return set_up(s, "arm"); }
int comedi_set_counter_mode(comedi_t*, unsigned s, unsigned, unsigned mode) {
  return set_up(s, (mode & NI_GPCT_COUNTING_MODE_MASK) == NI_GPCT_COUNTING_MODE_QUADRATURE_X4_BITS
                       ? "quadrature x4"
                       : "?");
}
int comedi_set_gate_source(comedi_t*, unsigned s, unsigned, unsigned, unsigned) {
  return set_up(s, "no gate");
}
int comedi_set_other_source(comedi_t*, unsigned s, unsigned, unsigned input, unsigned source) {
  const unsigned terminal = source <= 10 ? source - 1 : source - 11;  // as NI_USUAL_PFI_SELECT
  return set_up(
      s, (input == NI_GPCT_SOURCE_ENCODER_A ? "A from PFI " : "B from PFI ") + std::to_string(terminal));
}

}  // extern "C"
