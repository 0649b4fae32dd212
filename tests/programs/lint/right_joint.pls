# What stands between a joint and a command, or that it is the newest all the
# same, keeps it from being a mistake.
plsc 1
alphabet plasticoding 1
iterations 1

rule C -> {
  C
  add_left
  A1(0.5, 2, 3, 1)
  mutate_per(1)
  add_left  # expect warning[W4002]
  A1(0.5, 2, 3, 1)  # expect warning[W4002]
  add_front  # expect warning[W4002]
  mutate_amp(1)
  add_right
  B
  mutate_off(1)
}
