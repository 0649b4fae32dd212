plsc 1

# Robots that evolved with `profile: swift`, a file of a run each: p and b are the
# paper's runs (seed 1, Plasticoding and Baseline; the latter was stopped), w small ones of 60
# (40 + 40, by seed). Of the second half of each run the fastest, one of each pair of
# bodies and brains. Never made anew: solver_bench's figures are of these.

genotype p1_17287
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  move_front
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  add_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  move_right
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  T(-0.060381730392846)
  mutate_amp(0.2510153761151831)
  move_right
  B
  loop(0.832515509692555)
  add_front
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  mutate_edge(1.0371466534438674)
  add_left
  move_ref_N(1, 1)
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  loop(-0.8208636463798482)
  move_front
  move_ref_I(2, 2)
  add_front
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_right
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_20000
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_right
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_right
  move_front
  add_front
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
  loop(-0.7518505773184112)
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  move_ref_I(2, 2)
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False or inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  move_ref_I(1, 1)
  add_right
  T(0.5530587873902941)
  move_back
  move_ref_N(3, 1)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
}

rule A1 -> if inclined = False and inclined = True then {
  move_ref_N(2, 1)
  mutate_amp(0.2510153761151831)
  add_left
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  add_front
  move_left
  B
  move_right
  loop(0.832515509692555)
  A1(0.7003140781962487, 4.330448717009691, 8.299762792406035, 7.742249637042266)
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  add_right
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  add_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  add_edge(0.34194162751617996)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  mutate_edge(1.0371466534438674)
  add_left
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  add_front
  T(-0.7132868704065005)
  move_right
  loop(-0.8208636463798482)
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_edge(0.7624337080790671)
  add_left
}

genotype p1_19999
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  add_edge(-0.4652956660566876)
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  add_front
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  move_ref_I(2, 1)
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False or inclined = False then {
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  add_left
  move_front
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  move_right
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  move_right
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  mutate_amp(0.2510153761151831)
  B
  move_right
  loop(0.832515509692555)
  add_front
  T(-0.060381730392846)
  move_back
  move_ref_I(1, 2)
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  add_left
  move_right
  add_front
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  move_left
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  add_left
  mutate_edge(1.0371466534438674)
  move_ref_N(1, 1)
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  T(-0.7132868704065005)
  add_front
  move_right
  loop(-0.8208636463798482)
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19995
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False or inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  move_ref_I(1, 1)
  add_right
  T(0.5530587873902941)
  move_back
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
}

rule A1 -> if inclined = False and inclined = True then {
  move_ref_N(2, 1)
  mutate_amp(0.2510153761151831)
  add_left
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  add_front
  move_left
  B
  move_right
  loop(0.832515509692555)
  A1(0.7003140781962487, 4.330448717009691, 8.299762792406035, 7.742249637042266)
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  add_right
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  move_left
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  add_left
  mutate_edge(1.0371466534438674)
  move_ref_I(1, 1)
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_N(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  T(-0.7132868704065005)
  add_front
  move_right
  loop(-0.8208636463798482)
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19988
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  A2(-0.4629976122821424, 8.754290615612156, 3.975522352499245, 6.660914788079392)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  add_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  move_right
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  T(-0.060381730392846)
  mutate_amp(0.2510153761151831)
  move_right
  B
  loop(0.832515509692555)
  add_front
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_right
  loop(0.14336394067090774)
  B
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_ref_I(1, 1)
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  add_left
  move_ref_N(1, 1)
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  add_front
  move_ref_I(2, 2)
  move_right
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19984
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  add_edge(0.6531569758721048)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  A2(-0.4629976122821424, 8.754290615612156, 3.975522352499245, 6.660914788079392)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True and inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  add_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  loop(0.832515509692555)
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  move_ref_I(1, 1)
  add_edge(-0.9095717423370182)
  T(-0.060381730392846)
  mutate_amp(0.2510153761151831)
  move_right
  B
  move_right
  add_front
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  add_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  move_ref_N(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  mutate_edge(1.0371466534438674)
  add_left
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  move_ref_I(2, 2)
  add_front
  T(-0.7132868704065005)
  loop(-0.8208636463798482)
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19980
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True and inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.15201003578897399)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.45666530292687035)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  move_right
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False or inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  move_ref_I(1, 1)
  add_right
  T(0.5530587873902941)
  move_back
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
}

rule A1 -> if inclined = False and inclined = True then {
  move_ref_N(2, 1)
  mutate_amp(0.2510153761151831)
  add_left
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  add_front
  B
  move_right
  loop(0.832515509692555)
  A1(0.7003140781962487, 4.330448717009691, 8.299762792406035, 7.742249637042266)
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  add_right
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_ref_N(2, 1)
  move_left
  add_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  mutate_edge(1.0371466534438674)
  add_left
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  move_right
  T(-0.7132868704065005)
  move_ref_I(2, 2)
  loop(-0.8208636463798482)
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19901
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  mutate_edge(-2.059831247606112)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_I(1, 1)
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  add_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  B
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A2(-0.17436440909159168, 7.744509863684356, 1.5399031116405921, 1.044776028569546)
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  move_right
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  T(-0.060381730392846)
  mutate_amp(0.2510153761151831)
  move_right
  B
  loop(0.832515509692555)
  move_ref_I(1, 1)
  add_front
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  mutate_edge(1.0371466534438674)
  add_left
  move_ref_N(1, 1)
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
}

rule T -> if inclined = True and inclined = False then {
  add_front
  T(-0.7132868704065005)
  move_right
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19887
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True and inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  T(0.43043168968334755)
  move_right
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.15201003578897399)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.45666530292687035)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_ref_N(3, 1)
  add_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  B
  move_left
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  move_right
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  add_left
  T(-0.060381730392846)
  mutate_amp(0.2510153761151831)
  move_right
  B
  loop(0.832515509692555)
  add_front
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  add_left
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  move_ref_I(1, 2)
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_edge(-0.9167969147377153)
  add_front
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  move_left
  add_left
  T(-0.6193550792410378)
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  move_right
  add_left
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  mutate_edge(1.0371466534438674)
  B
}

rule T -> if inclined = True and inclined = False then {
  move_ref_I(2, 2)
  add_front
  T(-0.7132868704065005)
  loop(-0.8208636463798482)
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  move_front
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype p1_19752
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True and inclined = True then {
  C
  move_ref_N(2, 1)
  add_front
  add_front
  A2(-0.9419057172659095, 9.126461594111221, 7.6951285100495115, 6.686377191890508)
  move_front
  add_right
  mutate_off(0.7407648948600805)
  add_left
  move_right
  T(0.43043168968334755)
  move_ref_I(1, 2)
  mutate_off(-0.47984567569855624)
  move_ref_I(2, 1)
  A2(0.754066905256173, 9.748325247933872, 4.198737694452799, 7.419665458767977)
  move_right
  move_ref_N(1, 1)
  mutate_edge(0.5594663574431248)
  mutate_per(0.8314432956835773)
  loop(0.253980501329355)
  T(0.9664463609607294)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(0.45666530292687035)
  mutate_edge(-1.0975947183703694)
  add_left
  B
  move_front
  mutate_off(-1.2576929037036626)
  move_ref_I(1, 1)
  add_edge(0.15201003578897399)
  B
  add_front
  A2(-0.1478466804404075, 9.903569135473465, 9.570445599654729, 2.225262348868739)
  move_back
  move_ref_I(2, 2)
  move_ref_N(2, 1)
  add_right
  B
  move_front
  move_front
  move_ref_N(3, 2)
  mutate_per(-1.2093882883259015)
  add_right
  B
  mutate_off(-0.7847460193913331)
  move_front
}

rule B -> if inclined = False then {
  add_edge(-0.9037700593321378)
  move_front
  move_front
  move_ref_I(2, 1)
  mutate_edge(1.0133869989093427)
  add_left
  T(-0.8932784729833678)
  add_front
  move_right
  move_ref_N(1, 2)
  add_edge(-0.6523605893276527)
  move_right
  move_ref_I(1, 1)
  add_right
  T(-0.6794468720351758)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-1.1323275542656395)
  add_right
  A2(0.7185598073693364, 8.492300591781232, 8.675262648125864, 1.0226617240119038)
  move_front
  A2(0.7581853634127025, 1.9223394337772937, 7.016863165436755, 2.582655569408323)
}

rule B -> if inclined = True or inclined = True then {
  move_right
  move_ref_I(1, 2)
  B
  add_edge(-0.29466084852231167)
  move_ref_N(1, 1)
  move_left
  move_ref_N(1, 1)
  add_edge(-0.4816738632643893)
  add_front
  add_left
  move_front
  A1(-0.3551567909474991, 5.295882721664402, 6.33852600480897, 9.928271832415657)
  move_ref_N(1, 3)
  loop(-0.6373555363483974)
  A2(-0.7665969171386413, 2.7467335370016968, 8.681061735187567, 1.0677472456034733)
  add_left
  T(0.10299370210210479)
  move_left
  move_ref_N(2, 1)
  mutate_amp(-0.22466732041092985)
  add_front
  A2(0.5159375256587739, 3.1511610950530065, 1.6494985622731708, 1.037487539922516)
  move_back
}

rule A1 -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  loop(0.5670983213159215)
  add_right
  A1(-0.3946381610430054, 6.1349360675113624, 1.6413903515909136, 8.347810569621306)
  move_left
  move_ref_I(1, 1)
  move_ref_N(1, 2)
  mutate_amp(0.41837968098575357)
  add_left
  T(-0.7548388641696728)
  move_left
  add_left
  move_ref_I(2, 1)
  mutate_off(-0.5473180129981301)
  add_right
  T(0.5530587873902941)
  move_back
  A1(-0.08570622081746015, 4.857679216071196, 9.555503792250398, 2.6808525041329005)
  move_ref_N(3, 1)
  loop(-0.14507152669134693)
  add_front
  A1(-0.6360861382083549, 7.21343643387682, 1.3337539493324173, 6.374833358308988)
  move_left
}

rule A1 -> if inclined = False then {
  move_right
  add_right
  A1(0.39000816129500104, 5.833215650605068, 3.7009777349443946, 7.799327398997527)
  move_ref_N(2, 1)
  move_ref_N(1, 2)
  add_edge(-0.9095717423370182)
  T(-0.060381730392846)
  mutate_amp(0.2510153761151831)
  move_right
  B
  loop(0.832515509692555)
  add_front
  A2(-0.20763315747611055, 4.037473336594065, 8.626491379736297, 4.8116616919483866)
  move_back
  move_ref_I(1, 2)
  mutate_per(-0.9833721562476235)
  move_ref_I(1, 1)
  add_left
  move_right
  A2(0.8999560824776447, 2.7916290717100867, 8.027555202512886, 4.040837382512093)
  A1(0.7760777587919601, 7.885210717400832, 8.265720614426373, 7.429906789229557)
  add_right
}

rule A2 -> if inclined = True and inclined = False then {
  move_ref_I(1, 1)
  loop(0.14336394067090774)
  add_right
  A1(-0.8039248035579589, 6.817234458092786, 3.8586197542058454, 8.657310433989673)
  move_right
  move_ref_N(1, 1)
  move_ref_I(1, 3)
  add_front
  B
  move_left
  move_ref_I(1, 1)
  A2(0.5396214524134135, 6.408813043999478, 1.9541834873105943, 3.4390945956774965)
  loop(-0.5610922273324699)
  move_ref_N(1, 1)
  add_right
  T(-0.2955650957234013)
  move_back
  move_ref_N(2, 1)
  add_left
  T(-0.6193550792410378)
  move_left
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(-0.020398657087496316)
  add_right
  A1(-0.7459646740728965, 2.2361192938881644, 6.142715053754039, 8.131041642678085)
  move_right
  mutate_edge(1.0371466534438674)
  add_left
  A1(-0.3146360170768381, 8.324006203102181, 9.012668886128045, 3.743268688143116)
  move_left
  move_ref_I(1, 1)
  add_front
  add_right
  T(0.3497498249706503)
  mutate_edge(-0.016331933016113413)
  move_ref_N(2, 1)
  add_front
  move_right
  B
  A1(-0.32840826655590916, 7.277242640711158, 1.2445602485780127, 8.98891098045775)
}

rule T -> if inclined = True and inclined = False then {
  move_ref_I(2, 2)
  move_ref_I(2, 2)
  add_front
  mutate_per(1.270424587778427)
  T(-0.7132868704065005)
  loop(-0.8208636463798482)
  move_right
  move_back
}

rule T -> if inclined = False then {
  loop(-0.12618495759516035)
  A1(-0.7047891020240769, 1.0754468674767539, 9.079236963375386, 4.316804083866428)
  move_ref_N(2, 2)
  add_left
  add_edge(0.7624337080790671)
}

genotype b1_13228
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  move_ref_N(2, 1)
  move_ref_N(1, 1)
  add_left
  add_edge(0.766101229626635)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_edge(0.6561278661783629)
  add_right
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  mutate_amp(0.030761452945607566)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  add_front
  move_ref_N(1, 1)
  move_back
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 2)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  add_right
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  add_front
  mutate_amp(0.4516172423215866)
  move_right
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
  move_left
}

genotype b1_13625
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  add_edge(0.7156188932966674)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  move_ref_I(2, 1)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  add_right
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  mutate_amp(0.030761452945607566)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  add_edge(0.6561278661783629)
  move_ref_N(1, 1)
  move_back
  mutate_off(0.02726707433466645)
  move_right
  move_ref_N(3, 1)
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  mutate_amp(0.14097253812928684)
  move_ref_I(1, 2)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  B
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  add_right
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  mutate_amp(0.4516172423215866)
  move_right
  add_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
  move_left
}

genotype b1_13647
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  move_ref_I(2, 1)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  move_back
  move_ref_N(1, 1)
  add_edge(0.6561278661783629)
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 2)
  A2(0.8609736349676325, 7.046813450272156, 5.77765308258533, 8.82187376503176)
  mutate_edge(0.285645436460388)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  T(-0.5056278519987398)
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  add_front
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  move_ref_N(2, 3)
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  mutate_amp(0.4516172423215866)
  move_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
}

genotype b1_13628
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  mutate_per(0.16097441646596963)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  move_back
  move_ref_N(1, 1)
  add_edge(0.6561278661783629)
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 2)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  T(-0.5056278519987398)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  move_ref_N(1, 3)
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  mutate_amp(0.4516172423215866)
  move_right
  move_ref_I(2, 1)
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
}

genotype b1_13551
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  move_ref_N(1, 1)
  add_left
  add_edge(0.766101229626635)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  A1(0.45550037717487046, 9.636856100224154, 8.4286191395476, 6.56922502219376)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  move_ref_I(2, 1)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  move_back
  move_ref_N(1, 1)
  add_edge(0.6561278661783629)
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  move_ref_I(1, 2)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  T(-0.5056278519987398)
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  mutate_amp(0.4516172423215866)
  move_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
}

genotype b1_12963
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  move_back
  move_ref_N(1, 1)
  add_edge(0.6561278661783629)
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  T(-0.5056278519987398)
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  mutate_amp(0.4516172423215866)
  move_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
}

genotype b1_13633
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  move_ref_I(1, 1)
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  B
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  mutate_amp(0.030761452945607566)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  add_edge(0.6561278661783629)
  move_ref_N(1, 1)
  move_back
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 2)
  A2(0.8609736349676325, 7.046813450272156, 5.77765308258533, 8.82187376503176)
  mutate_edge(0.285645436460388)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  mutate_off(-1.0109838492022807)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  T(-0.5056278519987398)
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  add_front
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  mutate_amp(0.4516172423215866)
  move_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
  move_left
}

genotype b1_13604
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  move_ref_I(1, 2)
  mutate_per(2.1010346004311744)
  add_right
  B
  add_edge(0.6561278661783629)
  move_ref_N(1, 1)
  move_back
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  add_front
  move_ref_I(1, 2)
  A2(0.8609736349676325, 7.046813450272156, 5.77765308258533, 8.82187376503176)
  mutate_edge(0.285645436460388)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  T(-0.5056278519987398)
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
  mutate_amp(0.32639550093459585)
}

rule T -> {
  move_ref_N(1, 2)
  loop(-0.003747326994227196)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  add_front
  mutate_amp(0.4516172423215866)
  move_right
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
  move_left
}

genotype b1_13222
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.6852897559354498)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  loop(0.47379626753199133)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  add_right
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  mutate_amp(0.030761452945607566)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  add_edge(0.6561278661783629)
  move_ref_N(1, 1)
  move_back
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 2)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  add_right
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  mutate_amp(0.4516172423215866)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  loop(-0.003747326994227196)
  move_right
  add_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
  move_left
}

genotype b1_13672
alphabet plasticoding 1
axiom C
iterations 3
max_modules 15
move_to_new False
max_rules 1

rule C -> {
  C
  add_left
  T(-0.1670282842163766)
  loop(0.7557478199415453)
  move_right
  move_ref_I(1, 2)
  add_front
  A1(0.14514795672685743, 5.17590833809837, 8.270477053868744, 2.139650333330856)
  add_edge(0.766101229626635)
  add_left
  move_ref_N(1, 1)
  T(-0.45459031116264437)
  move_left
  move_ref_I(1, 1)
  move_front
  A1(0.22797116039958176, 9.045665174759765, 1.8277221794176872, 4.681682569501252)
  move_back
}

rule B -> {
  B
  mutate_off(0.41653495941085056)
  add_front
  A2(-0.26480265830212235, 4.537383244781417, 8.34808095496633, 3.650540358708692)
  move_left
  mutate_edge(-0.5237099466276943)
  loop(0.47379626753199133)
  add_front
  A1(0.40136370191722626, 1.334754991653851, 8.816363552758414, 6.229282571551856)
  add_edge(0.6737849031452185)
  loop(0.6852897559354498)
  move_right
  move_ref_I(1, 1)
  add_left
  A2(0.3521664395055488, 5.985401979599053, 3.097287604960455, 9.703263180604402)
  add_edge(-0.8867307376568137)
}

rule A1 -> {
  mutate_amp(-0.7843628084065494)
  add_left
  T(0.635097259372561)
  add_front
  add_right
  move_front
  move_ref_N(1, 1)
  mutate_off(-1.1281299047401943)
  mutate_amp(0.030761452945607566)
  add_left
  A1(0.9536652413176407, 4.480096623843072, 6.72291229419703, 1.2912221884325934)
  move_right
  move_ref_I(1, 1)
  mutate_per(2.1010346004311744)
  add_right
  B
  add_edge(0.6561278661783629)
  move_ref_N(1, 1)
  move_back
  mutate_off(0.02726707433466645)
  move_right
  T(0.08172506007838609)
  add_right
}

rule A2 -> {
  move_ref_I(1, 1)
  A1(-0.40389753109306437, 7.320459847160496, 6.50028029166904, 4.494649442653067)
  move_ref_I(1, 2)
  mutate_off(1.7162871596082931)
  T(0.4559397994908134)
  move_right
  move_ref_N(1, 2)
  add_front
  T(-0.3344522149584599)
  move_right
  move_ref_N(1, 3)
  loop(-0.3820504052774909)
  A2(0.1911360569614493, 5.920302245064963, 4.381313805159151, 3.550314972969775)
  add_right
  add_left
  move_front
  mutate_edge(0.4696305284310096)
  move_ref_I(1, 1)
  add_front
  A1(0.7423650098013277, 1.8861473513740414, 8.57710414859967, 8.561901834610627)
}

rule T -> {
  move_ref_N(1, 2)
  mutate_amp(0.4516172423215866)
  mutate_off(0.7982980135157001)
  add_front
  A2(-0.8872053358059204, 2.255737277951322, 4.895103099926094, 5.633656596806357)
  move_front
  move_ref_N(1, 2)
  mutate_amp(-0.23595358062413332)
  move_ref_I(1, 1)
  B
  move_back
  move_ref_N(2, 2)
  loop(-0.003747326994227196)
  move_right
  add_right
  move_back
  add_front
  mutate_off(-0.6221479919876701)
  add_right
  A1(-0.925117958194904, 3.29981897894566, 1.5311167769914302, 5.204953066186201)
  move_left
}

genotype w6_2389
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True and inclined = False then {
  move_ref_N(1, 1)
  add_front
  T(0.9276438849630921)
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  move_right
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  add_front
  move_ref_N(1, 1)
  mutate_off(-0.32617288353189533)
  move_back
  move_front
  T(0.49155261260083316)
  add_right
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  add_left
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  move_back
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2370
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 2)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  mutate_per(0.6239439269974788)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  add_front
  T(0.9276438849630921)
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  move_right
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  mutate_off(-0.32617288353189533)
  add_front
  move_front
  T(0.49155261260083316)
  add_right
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  add_left
  add_left
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2361
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True and inclined = False then {
  move_ref_N(1, 1)
  add_front
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  move_right
  move_ref_I(1, 1)
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  add_left
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_edge(-0.804965330253343)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  mutate_off(-0.32617288353189533)
  add_front
  move_front
  T(0.49155261260083316)
  add_right
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  add_left
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2279
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True and inclined = False then {
  move_ref_N(1, 1)
  add_front
  T(0.9276438849630921)
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  move_right
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  mutate_off(-0.32617288353189533)
  add_front
  move_front
  T(0.49155261260083316)
  add_right
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  add_left
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2387
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  add_front
  T(0.9276438849630921)
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  move_right
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  mutate_off(-0.32617288353189533)
  add_front
  move_front
  T(0.49155261260083316)
  add_right
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  add_left
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2284
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  add_edge(-0.8864331444279063)
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True and inclined = False then {
  move_ref_N(1, 1)
  T(0.9276438849630921)
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_edge(-0.804965330253343)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  move_right
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  add_right
  add_front
  move_front
  T(0.49155261260083316)
  mutate_off(-0.32617288353189533)
  move_ref_I(1, 2)
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  add_left
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2396
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True and inclined = False then {
  mutate_edge(-2.113438181664562)
  move_ref_N(1, 1)
  add_front
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_edge(-0.804965330253343)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_edge(0.36539918675116473)
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  add_right
  add_front
  move_front
  T(0.49155261260083316)
  mutate_off(-0.32617288353189533)
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  add_left
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w6_2262
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  mutate_per(0.6239439269974788)
  move_ref_N(1, 1)
  mutate_amp(0.39603766825480335)
  add_left
  move_ref_I(1, 2)
  A2(0.6875159224123255, 8.161613060676366, 6.7293834158194565, 6.421641088160456)
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.19254133272320298)
  add_left
  A1(0.9970338090622755, 2.45364485755461, 6.601806894849532, 1.191559347220117)
  A1(-0.9368360893650018, 2.8294754831103566, 9.960823414245528, 2.717069926840689)
  move_left
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_amp(2.0085435646269683)
  add_front
  T(0.41049542601940336)
  move_back
  move_ref_I(1, 2)
  mutate_off(-0.10055604039432989)
  mutate_amp(1.1029661623931992)
  mutate_edge(-0.8305185282537446)
  add_right
  A1(-0.7737584942611402, 6.842460796675978, 5.717985268286849, 5.271531754638821)
  move_back
}

rule B -> if inclined = True and inclined = False then {
  move_ref_N(1, 1)
  add_front
  move_front
}

rule B -> if inclined = False and inclined = False then {
  move_ref_N(1, 1)
  add_left
  mutate_amp(1.4612633464965485)
  T(0.552887483215829)
  move_right
}

rule A1 -> if inclined = True or inclined = False then {
  move_ref_N(1, 1)
  mutate_edge(-1.0186765503959339)
  add_right
  A1(-0.8924786816349508, 7.149614787961552, 9.324771647282965, 5.114924411338578)
  move_front
  move_ref_I(2, 2)
  mutate_off(-0.40302691786114075)
  add_front
  A1(-0.3826303866995826, 3.3554739386644163, 9.612636598564627, 7.751397175242183)
  move_back
  move_ref_I(2, 1)
  loop(-0.2925597625409455)
  A1(0.8592342420665087, 7.2118864255526764, 8.101715635702728, 6.999979447713903)
  add_front
  B
  move_right
  add_left
}

rule A1 -> if inclined = False then {
  move_ref_N(2, 2)
  mutate_off(-1.1708006463885683)
  add_front
  move_left
  move_ref_I(1, 1)
  add_edge(-0.8534092112075478)
  add_front
  A2(-0.26224396118005733, 1.6424314943656562, 9.55379475660334, 7.475189042194371)
  move_front
  move_ref_I(2, 2)
  T(-0.5245669188525266)
  add_left
  mutate_per(0.31605586840646327)
  move_left
}

rule A2 -> if inclined = False or inclined = True then {
  move_ref_N(1, 1)
  add_edge(-0.804965330253343)
  add_left
  T(-0.17988512632152087)
  move_left
  move_ref_I(2, 2)
  mutate_per(-0.4761170484209929)
  add_left
  A1(-0.5830903456467995, 6.9230765972898265, 6.633849031820014, 1.4221630445591267)
  move_back
}

rule A2 -> if inclined = False then {
  add_front
  mutate_edge(0.36539918675116473)
  mutate_off(0.9805322755497397)
  add_front
  A1(-0.30458389587357537, 8.859438606478877, 3.6546866171911954, 9.056265612754999)
  move_right
  move_ref_N(1, 1)
  mutate_edge(-0.044030922657618744)
  move_ref_N(1, 1)
  A2(-0.10529964860056884, 1.7695365060566899, 3.9669764534112253, 3.732141275568475)
  move_right
}

rule T -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.6515351713253081)
  add_left
  move_back
  move_ref_N(1, 1)
  add_right
  add_front
  move_front
  T(0.49155261260083316)
  mutate_off(-0.32617288353189533)
}

rule T -> if inclined = True or inclined = False then {
  move_ref_N(2, 1)
  add_edge(-0.11712225099133455)
  A2(-0.8619800182450841, 8.659959350463424, 8.93561108456543, 8.427203837483823)
  add_left
  move_back
  move_ref_N(1, 1)
  add_edge(-0.9280621899437966)
  add_left
  A1(-0.9478389540379268, 7.993580937867453, 7.2902224479497, 6.836051456861342)
}

genotype w8_2386
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 1)
  move_ref_N(1, 3)
  mutate_amp(-0.5521527876925154)
  add_left
  B
  move_front
  move_ref_I(1, 1)
  mutate_off(0.5971123797338246)
  add_front
  B
  move_back
  move_ref_N(1, 2)
  loop(-0.9680160186762705)
  add_right
  B
  move_back
}

rule C -> if inclined = False or inclined = False then {
  C
  move_ref_I(1, 2)
  mutate_per(1.55947849678178)
  add_right
  A2(0.445526135350907, 5.088864637488363, 3.2052451178372934, 5.987154423920176)
  move_front
  move_ref_N(1, 1)
  mutate_amp(0.3782813536733132)
  add_front
  mutate_off(-0.7381629537888392)
  B
  move_left
  move_ref_N(1, 1)
  move_front
  mutate_off(0.32239705457954493)
  add_right
  T(0.30349425449503054)
  move_left
}

rule B -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(0.6835015628458543)
  move_left
  move_ref_I(2, 1)
  mutate_off(0.19620992397808812)
  add_right
  A1(-0.04407894095955056, 3.2623628964793845, 6.5165305139514444, 2.9859364242739983)
  move_left
  move_ref_I(1, 1)
  mutate_per(-1.3071910778421547)
  add_right
  A1(-0.7220848439349807, 3.8812055432761277, 7.77294939963234, 7.897924353903246)
  move_right
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 2)
  add_right
  add_right
  B
  move_right
  move_ref_N(1, 1)
  mutate_edge(1.4845150627281207)
  add_left
  A2(0.2879642205450861, 2.5094360555858914, 8.075836022334336, 9.41678161795884)
  move_left
  add_right
  move_ref_I(1, 1)
  mutate_per(-1.175521213642097)
  add_left
  A1(0.9237773884578624, 7.252565831925048, 2.8623516017578736, 4.233570069876078)
  B
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_per(-0.10758116435782925)
  add_left
  A2(0.9630727632504643, 9.900753761979951, 7.732052413902036, 2.0269159937782417)
  move_left
  move_ref_I(1, 3)
  add_edge(0.990293061762384)
  add_front
  A2(0.7328172607206771, 7.75415436251219, 4.023832387917835, 1.2995442398428696)
  move_ref_N(1, 1)
  mutate_per(0.10785281046035838)
  add_right
  T(-0.9902252358591594)
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_off(-1.3102213797795756)
  add_front
  B
  move_back
  move_ref_N(1, 1)
  mutate_amp(0.24543917823951295)
  add_right
  T(0.24707437759717243)
  move_front
  move_ref_I(1, 2)
  mutate_per(0.03363315378660038)
  move_ref_I(1, 1)
  add_front
  A2(0.814563987938475, 5.672829681580308, 1.0045978141780747, 1.4756966277042503)
  move_front
}

rule A2 -> if inclined = True then {
  add_front
  move_ref_I(1, 2)
  move_back
  T(-0.7058724269422247)
  add_front
  mutate_amp(0.5370425440444531)
}

rule A2 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_amp(-0.6337618643177193)
  add_right
  B
  A2(0.7829693760168186, 4.867356421537565, 2.1794484756091284, 4.449473338770085)
  move_back
}

rule T -> if inclined = False or inclined = False then {
  add_edge(0.5530924246081037)
  add_left
  B
  move_back
  move_ref_I(1, 1)
  mutate_edge(0.4766512616188135)
  mutate_per(-0.6740467861868169)
  add_front
  move_front
  mutate_amp(0.033336300899217214)
  T(0.16173260874196216)
  add_right
  move_left
  move_ref_N(1, 2)
  loop(-0.4857733007843543)
  add_left
  T(0.8193970330314417)
  move_right
}

rule T -> if inclined = False and inclined = True then {
  move_ref_N(1, 1)
  add_right
  A1(0.9761324858989018, 1.8802937167627962, 6.162641249755386, 6.659810643024356)
  move_front
  move_ref_I(1, 2)
  mutate_edge(0.9373299003136898)
  add_left
  T(0.3131817123182594)
  move_front
  move_ref_I(2, 1)
  move_ref_I(1, 2)
  add_edge(-0.32122356200096513)
  add_left
  B
  move_left
}

genotype w8_2395
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 1)
  move_ref_N(1, 3)
  mutate_amp(-0.5521527876925154)
  add_left
  B
  move_front
  move_ref_I(1, 1)
  mutate_off(0.5971123797338246)
  add_front
  B
  move_back
  move_ref_N(1, 2)
  loop(-0.9680160186762705)
  add_right
  B
  move_back
}

rule C -> if inclined = False then {
  C
  move_ref_I(1, 2)
  mutate_per(1.55947849678178)
  add_right
  A2(0.445526135350907, 5.088864637488363, 3.2052451178372934, 5.987154423920176)
  move_front
  move_ref_N(1, 1)
  mutate_amp(0.3782813536733132)
  add_front
  mutate_off(-0.7381629537888392)
  B
  move_left
  move_ref_N(1, 1)
  move_front
  mutate_off(0.32239705457954493)
  add_right
  T(0.30349425449503054)
  loop(-0.4687550544768997)
  move_left
}

rule B -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(0.6835015628458543)
  move_left
  move_ref_I(2, 1)
  mutate_off(0.19620992397808812)
  add_right
  A1(-0.04407894095955056, 3.2623628964793845, 6.5165305139514444, 2.9859364242739983)
  move_left
  move_ref_I(1, 1)
  mutate_per(-1.3071910778421547)
  add_right
  A1(-0.7220848439349807, 3.8812055432761277, 7.77294939963234, 7.897924353903246)
  move_right
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 2)
  add_right
  B
  move_right
  move_ref_N(1, 1)
  add_left
  A2(0.2879642205450861, 2.5094360555858914, 8.075836022334336, 9.41678161795884)
  move_left
  add_right
  move_ref_I(1, 1)
  mutate_per(-1.175521213642097)
  add_left
  A1(0.9237773884578624, 7.252565831925048, 2.8623516017578736, 4.233570069876078)
  B
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_per(-0.10758116435782925)
  add_left
  A2(0.9630727632504643, 9.900753761979951, 7.732052413902036, 2.0269159937782417)
  move_left
  move_ref_I(1, 3)
  add_edge(0.990293061762384)
  add_front
  A2(0.7328172607206771, 7.75415436251219, 4.023832387917835, 1.2995442398428696)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.10785281046035838)
  add_right
  T(-0.9902252358591594)
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_off(-1.3102213797795756)
  add_front
  B
  move_back
  move_ref_N(1, 1)
  mutate_amp(0.24543917823951295)
  add_right
  T(0.24707437759717243)
  move_front
  move_ref_I(1, 2)
  mutate_per(0.03363315378660038)
  move_ref_I(1, 1)
  add_front
  A2(0.814563987938475, 5.672829681580308, 1.0045978141780747, 1.4756966277042503)
  move_front
}

rule A2 -> if inclined = True and inclined = True then {
  move_ref_I(1, 2)
  mutate_amp(0.5370425440444531)
  T(-0.7058724269422247)
  move_back
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_N(1, 1)
  mutate_amp(-0.6337618643177193)
  add_right
  B
}

rule T -> if inclined = False or inclined = False then {
  add_edge(0.5530924246081037)
  add_left
  B
  move_back
  move_ref_I(1, 1)
  mutate_edge(0.4766512616188135)
  mutate_per(-0.6740467861868169)
  add_front
  move_front
  T(0.16173260874196216)
  add_right
  move_left
  move_ref_N(1, 2)
  loop(-0.4857733007843543)
  add_left
  T(0.8193970330314417)
  move_right
}

rule T -> if inclined = False and inclined = True then {
  move_ref_N(1, 1)
  add_right
  A1(0.9761324858989018, 1.8802937167627962, 6.162641249755386, 6.659810643024356)
  move_front
  move_ref_I(1, 2)
  mutate_edge(0.9373299003136898)
  add_left
  T(0.3131817123182594)
  move_front
  move_ref_I(2, 1)
  move_ref_I(1, 2)
  add_edge(-0.32122356200096513)
  add_left
  B
  move_left
}

genotype w8_2400
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 1)
  move_ref_N(1, 3)
  mutate_amp(-0.5521527876925154)
  add_left
  B
  move_front
  move_ref_I(1, 1)
  add_front
  B
  move_back
  move_ref_N(1, 2)
  loop(-0.9680160186762705)
  add_right
  B
  move_back
}

rule C -> if inclined = False or inclined = False then {
  C
  move_ref_I(1, 2)
  mutate_per(1.55947849678178)
  add_right
  A2(0.445526135350907, 5.088864637488363, 3.2052451178372934, 5.987154423920176)
  move_front
  move_ref_N(1, 1)
  mutate_amp(0.3782813536733132)
  add_front
  mutate_off(-0.7381629537888392)
  B
  move_left
  move_ref_N(1, 1)
  move_front
  mutate_off(0.32239705457954493)
  add_right
  T(0.30349425449503054)
  move_left
}

rule B -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(0.6835015628458543)
  move_left
  move_ref_I(2, 1)
  mutate_off(0.19620992397808812)
  add_right
  A1(-0.04407894095955056, 3.2623628964793845, 6.5165305139514444, 2.9859364242739983)
  move_left
  move_ref_I(1, 1)
  mutate_per(-1.3071910778421547)
  add_right
  A1(-0.7220848439349807, 3.8812055432761277, 7.77294939963234, 7.897924353903246)
  move_right
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 2)
  add_right
  B
  move_right
  move_ref_N(1, 1)
  mutate_edge(1.4845150627281207)
  add_left
  A2(0.2879642205450861, 2.5094360555858914, 8.075836022334336, 9.41678161795884)
  move_left
  add_right
  move_ref_I(1, 1)
  mutate_per(-1.175521213642097)
  add_left
  A1(0.9237773884578624, 7.252565831925048, 2.8623516017578736, 4.233570069876078)
  B
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_per(-0.10758116435782925)
  add_left
  A2(0.9630727632504643, 9.900753761979951, 7.732052413902036, 2.0269159937782417)
  move_left
  move_ref_I(1, 3)
  add_edge(0.990293061762384)
  add_front
  A2(0.7328172607206771, 7.75415436251219, 4.023832387917835, 1.2995442398428696)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.10785281046035838)
  add_right
  T(-0.9902252358591594)
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_off(-1.3102213797795756)
  add_front
  B
  move_back
  move_ref_N(1, 1)
  mutate_amp(0.24543917823951295)
  add_right
  T(0.24707437759717243)
  move_front
  move_ref_I(1, 2)
  mutate_per(0.03363315378660038)
  move_ref_I(1, 1)
  add_front
  A2(0.814563987938475, 5.672829681580308, 1.0045978141780747, 1.4756966277042503)
  move_front
}

rule A2 -> if inclined = True and inclined = True then {
  move_back
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_I(2, 1)
  move_ref_N(1, 1)
  mutate_amp(-0.6337618643177193)
  add_right
  B
}

rule T -> if inclined = False or inclined = False then {
  add_edge(0.5530924246081037)
  add_left
  B
  move_back
  move_ref_I(1, 1)
  mutate_edge(0.4766512616188135)
  mutate_per(-0.6740467861868169)
  add_front
  move_front
  T(0.16173260874196216)
  add_right
  move_left
  move_ref_N(1, 2)
  loop(-0.4857733007843543)
  add_left
  T(0.8193970330314417)
  move_right
}

rule T -> if inclined = False and inclined = True then {
  move_ref_N(1, 1)
  add_right
  A1(0.9761324858989018, 1.8802937167627962, 6.162641249755386, 6.659810643024356)
  move_front
  move_ref_I(1, 2)
  mutate_edge(0.9373299003136898)
  add_left
  T(0.3131817123182594)
  move_front
  move_ref_I(2, 1)
  move_ref_I(1, 2)
  add_edge(-0.32122356200096513)
  add_left
  B
  move_left
}

genotype w8_2399
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 1)
  move_ref_N(1, 3)
  mutate_amp(-0.5521527876925154)
  add_left
  B
  move_front
  move_ref_I(1, 1)
  mutate_off(0.5971123797338246)
  add_front
  B
  move_back
  move_ref_N(1, 2)
  loop(-0.9680160186762705)
  add_right
  B
  move_back
}

rule C -> if inclined = False then {
  C
  move_ref_I(1, 2)
  mutate_per(1.55947849678178)
  add_right
  A2(0.445526135350907, 5.088864637488363, 3.2052451178372934, 5.987154423920176)
  move_front
  move_ref_N(1, 1)
  mutate_amp(0.3782813536733132)
  add_front
  mutate_off(-0.7381629537888392)
  B
  move_left
  move_ref_N(1, 1)
  move_front
  mutate_off(0.32239705457954493)
  add_right
  T(0.30349425449503054)
  move_left
}

rule B -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(0.6835015628458543)
  move_left
  move_ref_I(2, 1)
  mutate_off(0.19620992397808812)
  add_right
  A1(-0.04407894095955056, 3.2623628964793845, 6.5165305139514444, 2.9859364242739983)
  move_left
  move_ref_I(1, 1)
  mutate_per(-1.3071910778421547)
  add_right
  A1(-0.7220848439349807, 3.8812055432761277, 7.77294939963234, 7.897924353903246)
  move_right
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 2)
  add_right
  B
  move_right
  move_ref_N(1, 1)
  add_left
  A2(0.2879642205450861, 2.5094360555858914, 8.075836022334336, 9.41678161795884)
  move_left
  add_right
  move_ref_I(1, 1)
  mutate_per(-1.175521213642097)
  add_left
  A1(0.9237773884578624, 7.252565831925048, 2.8623516017578736, 4.233570069876078)
  B
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_per(-0.10758116435782925)
  add_left
  A2(0.9630727632504643, 9.900753761979951, 7.732052413902036, 2.0269159937782417)
  move_left
  move_ref_I(1, 3)
  add_edge(0.990293061762384)
  add_front
  A2(0.7328172607206771, 7.75415436251219, 4.023832387917835, 1.2995442398428696)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.10785281046035838)
  add_right
  T(-0.9902252358591594)
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_off(-1.3102213797795756)
  add_front
  B
  move_back
  move_ref_N(1, 1)
  mutate_amp(0.24543917823951295)
  add_right
  T(0.24707437759717243)
  move_front
  move_ref_I(1, 2)
  mutate_per(0.03363315378660038)
  move_ref_I(1, 1)
  add_front
  A2(0.814563987938475, 5.672829681580308, 1.0045978141780747, 1.4756966277042503)
  mutate_edge(0.7096757185442942)
  move_front
}

rule A2 -> if inclined = True and inclined = True then {
  move_back
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_N(1, 1)
  mutate_amp(-0.6337618643177193)
  add_right
  B
}

rule T -> if inclined = False or inclined = False then {
  add_edge(0.5530924246081037)
  add_left
  B
  move_back
  move_ref_I(1, 1)
  mutate_edge(0.4766512616188135)
  mutate_per(-0.6740467861868169)
  add_front
  move_front
  T(0.16173260874196216)
  add_right
  move_left
  move_ref_N(1, 2)
  loop(-0.4857733007843543)
  add_left
  T(0.8193970330314417)
  move_right
}

rule T -> if inclined = False and inclined = True then {
  move_ref_N(1, 1)
  add_right
  A1(0.9761324858989018, 1.8802937167627962, 6.162641249755386, 6.659810643024356)
  move_front
  move_ref_I(1, 2)
  mutate_edge(0.9373299003136898)
  add_left
  move_front
  T(0.3131817123182594)
  move_ref_I(2, 1)
  move_ref_I(1, 2)
  add_edge(-0.32122356200096513)
  add_left
  B
  move_left
}

genotype w8_2392
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 1)
  move_ref_N(1, 3)
  mutate_amp(-0.5521527876925154)
  add_left
  B
  move_front
  move_ref_I(1, 1)
  mutate_off(0.5971123797338246)
  add_front
  B
  move_ref_N(1, 2)
  loop(-0.9680160186762705)
  add_right
  B
  move_back
}

rule C -> if inclined = False or inclined = False then {
  C
  move_ref_I(1, 2)
  mutate_per(1.55947849678178)
  add_right
  A2(0.445526135350907, 5.088864637488363, 3.2052451178372934, 5.987154423920176)
  move_front
  move_ref_N(1, 1)
  mutate_amp(0.3782813536733132)
  add_front
  mutate_off(-0.7381629537888392)
  B
  move_left
  move_ref_N(1, 1)
  move_front
  mutate_off(0.32239705457954493)
  add_right
  T(0.30349425449503054)
  move_left
}

rule B -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(0.6835015628458543)
  move_left
  move_ref_I(2, 1)
  mutate_off(0.19620992397808812)
  add_right
  A1(-0.04407894095955056, 3.2623628964793845, 6.5165305139514444, 2.9859364242739983)
  move_left
  move_ref_I(1, 1)
  mutate_per(-1.3071910778421547)
  add_right
  A1(-0.7220848439349807, 3.8812055432761277, 7.77294939963234, 7.897924353903246)
  move_right
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 2)
  add_right
  B
  move_right
  move_ref_N(1, 1)
  add_left
  A2(0.2879642205450861, 2.5094360555858914, 8.075836022334336, 9.41678161795884)
  move_left
  add_right
  move_ref_I(1, 1)
  mutate_per(-1.175521213642097)
  A1(0.9237773884578624, 7.252565831925048, 2.8623516017578736, 4.233570069876078)
  B
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_per(-0.10758116435782925)
  add_left
  A2(0.9630727632504643, 9.900753761979951, 7.732052413902036, 2.0269159937782417)
  move_left
  move_ref_I(1, 3)
  add_edge(0.990293061762384)
  add_front
  A2(0.7328172607206771, 7.75415436251219, 4.023832387917835, 1.2995442398428696)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.10785281046035838)
  add_right
  T(-0.9902252358591594)
  move_back
}

rule A1 -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  mutate_off(-1.3102213797795756)
  add_front
  B
  move_back
  move_ref_N(1, 1)
  mutate_amp(0.24543917823951295)
  add_right
  T(0.24707437759717243)
  move_front
  move_ref_I(1, 2)
  mutate_per(0.03363315378660038)
  move_ref_I(1, 1)
  add_front
  A2(0.814563987938475, 5.672829681580308, 1.0045978141780747, 1.4756966277042503)
  move_front
}

rule A2 -> if inclined = True and inclined = True then {
  move_back
  mutate_amp(-0.9650159244034557)
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_N(1, 1)
  mutate_amp(-0.6337618643177193)
  add_right
  B
}

rule T -> if inclined = False or inclined = False then {
  add_edge(0.5530924246081037)
  add_left
  B
  move_back
  move_ref_I(1, 1)
  mutate_edge(0.4766512616188135)
  mutate_per(-0.6740467861868169)
  add_front
  move_front
  T(0.16173260874196216)
  add_right
  move_left
  move_ref_N(1, 2)
  loop(-0.4857733007843543)
  add_left
  T(0.8193970330314417)
  move_right
}

rule T -> if inclined = False and inclined = True then {
  move_ref_N(1, 1)
  add_right
  A1(0.9761324858989018, 1.8802937167627962, 6.162641249755386, 6.659810643024356)
  move_front
  move_ref_I(1, 2)
  mutate_edge(0.9373299003136898)
  add_left
  T(0.3131817123182594)
  move_front
  move_ref_I(2, 1)
  add_edge(-0.32122356200096513)
  move_ref_I(1, 2)
  add_left
  B
  move_left
}

genotype w8_2377
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 1)
  move_ref_N(1, 3)
  mutate_amp(-0.5521527876925154)
  add_left
  B
  move_front
  move_ref_I(1, 1)
  mutate_off(0.5971123797338246)
  add_front
  B
  move_back
  move_ref_N(1, 2)
  loop(-0.9680160186762705)
  add_right
  B
  move_back
}

rule C -> if inclined = False then {
  C
  move_ref_I(1, 2)
  mutate_per(1.55947849678178)
  add_right
  A2(0.445526135350907, 5.088864637488363, 3.2052451178372934, 5.987154423920176)
  move_front
  move_ref_N(1, 1)
  mutate_amp(0.3782813536733132)
  add_front
  mutate_off(-0.7381629537888392)
  B
  move_left
  move_ref_N(1, 1)
  move_front
  mutate_off(0.32239705457954493)
  add_right
  T(0.30349425449503054)
  move_left
}

rule B -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_left
  T(0.6835015628458543)
  move_left
  move_ref_I(2, 1)
  mutate_off(0.19620992397808812)
  add_right
  A1(-0.04407894095955056, 3.2623628964793845, 6.5165305139514444, 2.9859364242739983)
  move_left
  move_ref_I(1, 1)
  mutate_per(-1.3071910778421547)
  add_right
  A1(-0.7220848439349807, 3.8812055432761277, 7.77294939963234, 7.897924353903246)
  move_right
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 2)
  add_right
  B
  move_right
  move_ref_N(1, 1)
  mutate_edge(1.4845150627281207)
  add_left
  A2(0.2879642205450861, 2.5094360555858914, 8.075836022334336, 9.41678161795884)
  mutate_per(-1.175521213642097)
  add_right
  move_ref_I(1, 1)
  move_left
  add_left
  A1(0.9237773884578624, 7.252565831925048, 2.8623516017578736, 4.233570069876078)
  B
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_per(-0.10758116435782925)
  add_left
  A2(0.9630727632504643, 9.900753761979951, 7.732052413902036, 2.0269159937782417)
  move_left
  move_ref_I(1, 3)
  add_edge(0.990293061762384)
  add_front
  A2(0.7328172607206771, 7.75415436251219, 4.023832387917835, 1.2995442398428696)
  move_right
  move_ref_N(1, 1)
  mutate_per(0.10785281046035838)
  add_right
  T(-0.9902252358591594)
  move_back
}

rule A1 -> if inclined = True then {
  move_ref_N(1, 1)
  mutate_off(-1.3102213797795756)
  add_front
  B
  move_back
  move_ref_N(1, 1)
  mutate_amp(0.24543917823951295)
  add_right
  T(0.24707437759717243)
  move_front
  move_ref_I(1, 2)
  mutate_per(0.03363315378660038)
  move_ref_I(1, 1)
  add_front
  A2(0.814563987938475, 5.672829681580308, 1.0045978141780747, 1.4756966277042503)
  mutate_edge(0.7096757185442942)
  move_front
}

rule A2 -> if inclined = True and inclined = True then {
  A1(0.5686743535747552, 7.20034896573932, 5.919830662214841, 5.594546670715433)
  move_back
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_N(1, 1)
  mutate_amp(-0.6337618643177193)
  add_right
  B
}

rule T -> if inclined = False or inclined = False then {
  add_edge(0.5530924246081037)
  add_left
  B
  move_back
  move_ref_I(1, 1)
  mutate_edge(0.4766512616188135)
  mutate_per(-0.6740467861868169)
  add_front
  move_front
  T(0.16173260874196216)
  add_right
  move_left
  move_ref_N(1, 2)
  loop(-0.4857733007843543)
  add_left
  T(0.8193970330314417)
  move_right
}

rule T -> if inclined = False and inclined = True then {
  move_ref_N(1, 1)
  add_right
  A1(0.9761324858989018, 1.8802937167627962, 6.162641249755386, 6.659810643024356)
  move_front
  move_ref_I(1, 2)
  mutate_edge(0.9373299003136898)
  add_left
  T(0.3131817123182594)
  move_front
  move_ref_I(2, 1)
  move_ref_I(1, 2)
  add_edge(-0.32122356200096513)
  add_left
  B
  move_left
}

genotype w4_2399
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = False or inclined = True then {
  C
  move_ref_I(1, 1)
  mutate_amp(-0.5652818495548686)
  add_left
  A2(0.21277182162807007, 9.539747034127132, 6.381735028422536, 3.7631874244224304)
  move_front
  move_ref_N(1, 1)
  add_edge(-0.5763854913532522)
  add_right
  A2(0.4814771430409437, 3.5074464529919958, 9.747793552519365, 5.398246333944523)
  move_front
}

rule C -> if inclined = False and inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_edge(0.5467455650894198)
  move_front
  move_ref_N(2, 1)
  mutate_amp(-0.5333208759992218)
  add_left
  B
  move_front
}

rule B -> if inclined = False or inclined = True then {
  move_ref_I(2, 3)
  add_right
  add_right
  A2(0.1568779240139344, 4.678289569327147, 8.081950448927994, 1.1250596793813783)
  move_ref_N(2, 1)
  move_front
  B
  move_right
}

rule B -> if inclined = True and inclined = False then {
  move_ref_I(2, 1)
  loop(0.7805759146932307)
  add_front
  move_right
  A2(0.5980142323170905, 8.636282236021009, 6.00687261602232, 7.994456298116759)
  move_back
  move_ref_I(1, 1)
  loop(-0.642684678873187)
  add_right
  A1(0.795759242710504, 3.7131906424507934, 6.219440494881704, 9.104900150816142)
  move_left
}

rule A1 -> if inclined = True then {
  move_ref_N(3, 1)
  mutate_per(1.6747859287142088)
  add_front
  A2(-0.1458392752159312, 3.758042162047704, 9.471557561831673, 5.344392307886919)
  move_back
  move_ref_I(1, 1)
  add_left
  A2(-0.6254134603781518, 1.463555082424128, 3.204441314700461, 7.326460455031)
  move_right
}

rule A1 -> if inclined = False then {
  move_left
  mutate_off(1.3785216379668412)
  add_right
  A2(0.7471029466924393, 3.6007560544717765, 2.465432659223765, 9.013078792246299)
  add_front
  move_left
  move_ref_I(1, 2)
  add_left
  B
  move_ref_I(1, 2)
}

rule A2 -> if inclined = True then {
  mutate_per(0.9592419642184533)
  move_ref_I(1, 1)
  add_right
  A1(-0.7476920229830675, 3.5306141770322887, 1.6044045400679532, 2.84555016673519)
  move_front
  move_ref_I(1, 1)
  mutate_edge(-1.6087389612187317)
  add_left
  A1(-0.2045180868308325, 5.04638891104561, 7.477369016701944, 6.991158917009908)
  move_back
}

rule A2 -> if inclined = False then {
  move_ref_I(1, 1)
  loop(-0.4265471195681301)
  move_right
  add_right
  T(0.7771031016535253)
  move_right
  move_ref_N(1, 1)
  mutate_amp(-1.9097971247018932)
  add_front
  T(-0.8690441868631951)
  move_right
}

rule T -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_edge(0.3613597886933675)
  add_front
  A1(0.8307025793403648, 9.204213409669787, 6.948076037054448, 2.9305756296804875)
  move_right
  move_ref_I(1, 1)
  mutate_per(1.5730004215353177)
  add_right
  add_right
  A2(0.025532018717138616, 5.762896664937259, 2.762956102145105, 2.2962342038757373)
  move_right
}

rule T -> if inclined = False then {
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  mutate_per(-0.9742633970367207)
  add_front
  A2(-0.5991242000423769, 1.8778242356741837, 4.213524908755597, 3.503307903827631)
  move_right
  move_ref_I(2, 1)
  mutate_edge(0.16047073525907868)
  add_left
  A1(-0.8067231598913818, 9.663679280968298, 3.313395630394742, 5.858264941915855)
  move_left
}

genotype w4_2305
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = False or inclined = True then {
  C
  move_ref_I(1, 1)
  mutate_amp(-0.5652818495548686)
  add_left
  A2(0.21277182162807007, 9.539747034127132, 6.381735028422536, 3.7631874244224304)
  move_front
  move_ref_N(1, 1)
  add_edge(-0.5763854913532522)
  add_right
  A2(0.4814771430409437, 3.5074464529919958, 9.747793552519365, 5.398246333944523)
  move_front
}

rule C -> if inclined = False or inclined = False then {
  C
  move_ref_N(1, 1)
  mutate_edge(0.5467455650894198)
  move_front
  move_ref_N(2, 1)
  mutate_amp(-0.5333208759992218)
  add_left
  B
  move_front
}

rule B -> if inclined = False or inclined = True then {
  move_ref_I(2, 3)
  add_right
  add_right
  A2(0.1568779240139344, 4.678289569327147, 8.081950448927994, 1.1250596793813783)
  move_front
  B
  move_right
}

rule B -> if inclined = True and inclined = False then {
  move_ref_I(2, 1)
  loop(0.7805759146932307)
  add_front
  move_right
  A2(0.5980142323170905, 8.636282236021009, 6.00687261602232, 7.994456298116759)
  move_back
  move_ref_I(1, 1)
  loop(-0.642684678873187)
  add_right
  A1(0.795759242710504, 3.7131906424507934, 6.219440494881704, 9.104900150816142)
  move_left
}

rule A1 -> if inclined = True then {
  move_ref_N(3, 1)
  mutate_per(1.6747859287142088)
  add_front
  A2(-0.1458392752159312, 3.758042162047704, 9.471557561831673, 5.344392307886919)
  move_back
  move_ref_I(1, 1)
  add_left
  A2(-0.6254134603781518, 1.463555082424128, 3.204441314700461, 7.326460455031)
  move_right
}

rule A1 -> if inclined = False then {
  move_left
  mutate_off(1.3785216379668412)
  add_right
  A2(0.7471029466924393, 3.6007560544717765, 2.465432659223765, 9.013078792246299)
  move_left
  move_ref_I(1, 2)
  add_left
  B
  move_right
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_per(0.9592419642184533)
  add_right
  A1(-0.7476920229830675, 3.5306141770322887, 1.6044045400679532, 2.84555016673519)
  move_front
  move_ref_I(1, 1)
  mutate_edge(-1.6087389612187317)
  add_left
  A1(0.5246726936776134, 5.70213815309917, 4.149294320693478, 3.68144257672874)
  A1(-0.2045180868308325, 5.04638891104561, 7.477369016701944, 6.991158917009908)
  move_back
}

rule A2 -> if inclined = False then {
  move_ref_I(1, 1)
  loop(-0.4265471195681301)
  move_right
  add_right
  T(0.7771031016535253)
  move_right
  move_ref_N(1, 1)
  mutate_amp(-1.9097971247018932)
  add_front
  T(-0.8690441868631951)
  move_right
}

rule T -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_edge(0.3613597886933675)
  add_front
  A1(0.8307025793403648, 9.204213409669787, 6.948076037054448, 2.9305756296804875)
  move_right
  move_ref_I(1, 1)
  mutate_per(1.5730004215353177)
  add_right
  add_right
  A2(0.025532018717138616, 5.762896664937259, 2.762956102145105, 2.2962342038757373)
  move_right
}

rule T -> if inclined = False then {
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  mutate_per(-0.9742633970367207)
  add_front
  A2(-0.5991242000423769, 1.8778242356741837, 4.213524908755597, 3.503307903827631)
  move_right
  move_ref_I(2, 1)
  mutate_edge(0.16047073525907868)
  add_left
  A1(-0.8067231598913818, 9.663679280968298, 3.313395630394742, 5.858264941915855)
  move_left
}

genotype w4_2283
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = False or inclined = True then {
  C
  move_ref_I(1, 1)
  mutate_amp(-0.5652818495548686)
  add_left
  A2(0.21277182162807007, 9.539747034127132, 6.381735028422536, 3.7631874244224304)
  move_front
  move_ref_N(1, 1)
  add_edge(-0.5763854913532522)
  add_right
  A2(0.4814771430409437, 3.5074464529919958, 9.747793552519365, 5.398246333944523)
  move_front
}

rule C -> if inclined = False then {
  C
  move_ref_N(1, 1)
  add_left
  mutate_edge(0.5467455650894198)
  move_front
  move_ref_N(2, 1)
  mutate_amp(-0.5333208759992218)
  add_left
  B
  move_front
}

rule B -> if inclined = False or inclined = True then {
  move_ref_I(2, 3)
  add_right
  add_right
  A2(0.1568779240139344, 4.678289569327147, 8.081950448927994, 1.1250596793813783)
  move_front
  B
  move_right
}

rule B -> if inclined = True and inclined = False then {
  move_ref_I(2, 1)
  loop(0.7805759146932307)
  add_front
  move_right
  A2(0.5980142323170905, 8.636282236021009, 6.00687261602232, 7.994456298116759)
  move_back
  move_ref_I(1, 1)
  loop(-0.642684678873187)
  add_right
  A1(0.795759242710504, 3.7131906424507934, 6.219440494881704, 9.104900150816142)
  move_left
}

rule A1 -> if inclined = True then {
  move_ref_N(3, 1)
  mutate_per(1.6747859287142088)
  add_front
  A2(-0.1458392752159312, 3.758042162047704, 9.471557561831673, 5.344392307886919)
  move_back
  move_ref_I(1, 1)
  add_left
  A2(-0.6254134603781518, 1.463555082424128, 3.204441314700461, 7.326460455031)
  move_right
}

rule A1 -> if inclined = False then {
  move_left
  mutate_off(1.3785216379668412)
  add_right
  A2(0.7471029466924393, 3.6007560544717765, 2.465432659223765, 9.013078792246299)
  move_left
  move_ref_I(1, 2)
  add_left
  B
}

rule A2 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_per(0.9592419642184533)
  add_left
  move_front
  A1(-0.7476920229830675, 3.5306141770322887, 1.6044045400679532, 2.84555016673519)
  move_ref_I(1, 1)
  mutate_edge(-1.6087389612187317)
  add_right
  A1(-0.2045180868308325, 5.04638891104561, 7.477369016701944, 6.991158917009908)
  move_back
}

rule A2 -> if inclined = False then {
  move_ref_I(1, 1)
  loop(-0.4265471195681301)
  add_right
  T(0.7771031016535253)
  move_right
  move_ref_N(1, 1)
  mutate_amp(-1.9097971247018932)
  add_front
  T(-0.8690441868631951)
  move_right
}

rule T -> if inclined = True and inclined = True then {
  move_ref_N(1, 1)
  add_edge(0.3613597886933675)
  add_front
  A1(0.8307025793403648, 9.204213409669787, 6.948076037054448, 2.9305756296804875)
  move_right
  move_ref_I(1, 1)
  mutate_per(1.5730004215353177)
  add_right
  add_right
  A2(0.025532018717138616, 5.762896664937259, 2.762956102145105, 2.2962342038757373)
  move_right
}

rule T -> if inclined = False then {
  move_ref_I(1, 1)
  move_ref_I(1, 1)
  mutate_per(-0.9742633970367207)
  add_front
  A2(-0.5991242000423769, 1.8778242356741837, 4.213524908755597, 3.503307903827631)
  move_right
  move_ref_I(2, 1)
  mutate_edge(0.16047073525907868)
  add_left
  A1(-0.8067231598913818, 9.663679280968298, 3.313395630394742, 5.858264941915855)
  move_left
}

genotype w1_1961
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 2)
  mutate_off(-1.0609779061923963)
  add_front
  T(-0.2975717833683751)
  move_right
  T(-0.731909861418367)
}

rule C -> if inclined = False or inclined = True then {
  C
  mutate_off(-0.678467763852617)
  move_ref_I(1, 1)
  add_front
  A2(0.8078366918913096, 9.473324728477463, 3.3273195239303854, 8.42714884192506)
  move_front
  move_ref_N(1, 1)
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 1)
  mutate_off(0.6786546515353249)
  add_right
  T(0.5881878137587628)
  move_back
}

rule B -> if inclined = True then {
  move_ref_I(1, 1)
  loop(-0.3513172396439428)
  add_front
  A2(-0.5566631488752358, 6.962071011459143, 2.0057112429657913, 9.666255801641224)
  move_left
}

rule A1 -> if inclined = False then {
  move_ref_I(1, 1)
  mutate_per(-1.2547993464517142)
  add_left
  B
  move_back
  move_ref_N(1, 1)
  move_ref_I(1, 1)
  mutate_amp(0.4184409098533202)
  add_front
  A2(-0.20909360446280756, 1.643025910731604, 3.718613033516916, 4.258185789710014)
  move_front
  move_ref_I(1, 1)
  add_edge(-0.21989109604077894)
  add_front
  move_left
}

rule A1 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(0.7632825489445486)
  move_left
  add_front
  A2(0.1716352588811001, 3.84167649566386, 2.265563871991154, 9.409801459340374)
  move_right
  move_ref_I(1, 2)
  mutate_per(0.8970886476068016)
  add_left
  move_ref_N(2, 1)
  move_front
  A2(0.5617481569364962, 1.1485450540547935, 7.596137765393042, 6.513976972096501)
  mutate_per(-0.6800944451030667)
  add_right
  T(0.8063032588119501)
  move_right
}

rule A2 -> if inclined = True or inclined = True then {
  move_back
  move_ref_N(2, 2)
  mutate_off(-0.05143713060994505)
  add_right
  B
  move_right
}

rule A2 -> if inclined = False then {
  T(0.3355302970536851)
  add_right
  A1(-0.9230712363555154, 9.867973491896002, 1.0332847662894473, 5.073298314363913)
  move_front
  B
}

rule T -> if inclined = False or inclined = True then {
  move_ref_I(1, 2)
  move_front
  add_right
  A1(-0.18565993630217426, 5.506558505221247, 9.673753514685046, 4.90566915766782)
  move_back
  move_ref_N(2, 2)
  mutate_off(0.1389566363436248)
  add_left
  A1(0.6792102999287781, 2.512931565248651, 1.7548894966087267, 2.2424106119020566)
  mutate_off(0.07387993237540717)
}

rule T -> if inclined = False then {
  A2(-0.9404837751482618, 2.345633935240178, 7.854864421678398, 7.988805925448291)
  move_ref_I(2, 1)
  mutate_off(1.2596656665534844)
  move_front
  add_right
  move_back
  B
  move_ref_N(1, 1)
  mutate_edge(0.7902641706231178)
  add_front
  A2(-0.02565562240266739, 2.7969399430688466, 9.318011125443718, 3.774120824774773)
  move_back
}

genotype w1_1891
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 2)
  mutate_off(-1.0609779061923963)
  add_front
  T(-0.2975717833683751)
  move_right
  T(-0.731909861418367)
}

rule C -> if inclined = False or inclined = True then {
  C
  mutate_off(-0.678467763852617)
  move_ref_I(1, 1)
  add_front
  A2(0.8078366918913096, 9.473324728477463, 3.3273195239303854, 8.42714884192506)
  move_front
  move_ref_N(1, 1)
}

rule B -> if inclined = True and inclined = False then {
  T(0.5881878137587628)
  mutate_off(0.6786546515353249)
  add_right
  move_ref_I(1, 1)
  move_back
}

rule B -> if inclined = False then {
  move_ref_I(1, 1)
  loop(-0.3513172396439428)
  add_front
  move_left
}

rule A1 -> if inclined = False then {
  move_ref_I(1, 1)
  mutate_per(-1.2547993464517142)
  add_left
  B
  move_back
  move_ref_N(1, 1)
  move_ref_I(1, 1)
  mutate_amp(0.4184409098533202)
  add_front
  A2(-0.20909360446280756, 1.643025910731604, 3.718613033516916, 4.258185789710014)
  move_front
  move_ref_I(1, 1)
  add_edge(-0.21989109604077894)
  add_front
  T(0.06570949391815595)
  move_left
}

rule A1 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(0.7632825489445486)
  move_left
  add_front
  A2(0.1716352588811001, 3.84167649566386, 2.265563871991154, 9.409801459340374)
  move_right
  move_ref_I(1, 2)
  mutate_per(0.8970886476068016)
  add_left
  move_ref_N(2, 1)
  move_front
  A2(0.5617481569364962, 1.1485450540547935, 7.596137765393042, 6.513976972096501)
  mutate_per(-0.6800944451030667)
  add_right
  T(0.8063032588119501)
  move_right
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_N(2, 2)
  add_left
  mutate_off(-0.05143713060994505)
  add_right
  B
  move_right
}

rule A2 -> if inclined = False then {
  T(0.3355302970536851)
  A1(-0.9230712363555154, 9.867973491896002, 1.0332847662894473, 5.073298314363913)
  move_front
  B
}

rule T -> if inclined = False or inclined = True then {
  move_ref_I(1, 2)
  move_front
  add_right
  A1(-0.18565993630217426, 5.506558505221247, 9.673753514685046, 4.90566915766782)
  move_back
  move_ref_N(2, 2)
  mutate_off(0.1389566363436248)
  add_left
  A1(0.6792102999287781, 2.512931565248651, 1.7548894966087267, 2.2424106119020566)
  mutate_off(0.07387993237540717)
}

rule T -> if inclined = False then {
  A2(-0.9404837751482618, 2.345633935240178, 7.854864421678398, 7.988805925448291)
  mutate_off(1.2596656665534844)
  move_front
  add_right
  move_back
  B
  move_ref_N(1, 1)
  mutate_edge(0.7902641706231178)
  add_front
  A2(-0.02565562240266739, 2.7969399430688466, 9.318011125443718, 3.774120824774773)
  move_back
}

genotype w1_1917
alphabet plasticoding 1
sense inclined: bool
axiom C
iterations 3
max_modules 15
move_to_new False
max_terms 2
max_rules 2

rule C -> if inclined = True then {
  C
  move_ref_I(1, 2)
  mutate_off(-1.0609779061923963)
  add_front
  T(-0.2975717833683751)
  move_right
  T(-0.731909861418367)
}

rule C -> if inclined = False or inclined = True then {
  C
  mutate_off(-0.678467763852617)
  move_ref_I(1, 1)
  add_front
  A2(0.8078366918913096, 9.473324728477463, 3.3273195239303854, 8.42714884192506)
  move_front
  move_ref_N(1, 1)
}

rule B -> if inclined = False and inclined = False then {
  move_ref_I(1, 1)
  mutate_off(0.6786546515353249)
  add_right
  move_front
  T(0.5881878137587628)
  move_back
}

rule B -> if inclined = False then {
  move_ref_I(1, 1)
  loop(-0.3513172396439428)
  add_front
  A2(-0.5566631488752358, 6.962071011459143, 2.0057112429657913, 9.666255801641224)
  move_left
}

rule A1 -> if inclined = False then {
  move_ref_I(1, 1)
  mutate_per(-1.2547993464517142)
  add_left
  B
  move_back
  move_ref_N(1, 1)
  move_ref_I(1, 1)
  mutate_amp(0.4184409098533202)
  add_front
  A2(-0.20909360446280756, 1.643025910731604, 3.718613033516916, 4.258185789710014)
  move_front
  move_ref_I(1, 1)
  add_edge(-0.21989109604077894)
  add_front
  T(0.06570949391815595)
  move_left
}

rule A1 -> if inclined = True then {
  move_ref_I(1, 1)
  mutate_edge(0.7632825489445486)
  move_left
  add_front
  A2(0.1716352588811001, 3.84167649566386, 2.265563871991154, 9.409801459340374)
  move_right
  move_ref_I(1, 2)
  mutate_per(0.8970886476068016)
  add_left
  move_ref_N(2, 1)
  move_front
  A2(0.5617481569364962, 1.1485450540547935, 7.596137765393042, 6.513976972096501)
  mutate_per(-0.6800944451030667)
  add_right
  T(0.8063032588119501)
  move_right
}

rule A2 -> if inclined = True or inclined = True then {
  move_ref_N(2, 2)
  mutate_off(-0.05143713060994505)
  add_right
  B
  move_right
}

rule A2 -> if inclined = False then {
  T(0.3355302970536851)
  add_right
  A1(-0.9230712363555154, 9.867973491896002, 1.0332847662894473, 5.073298314363913)
  move_front
  B
}

rule T -> if inclined = False or inclined = True then {
  move_ref_I(1, 2)
  move_front
  add_right
  A1(-0.18565993630217426, 5.506558505221247, 9.673753514685046, 4.90566915766782)
  move_back
  move_ref_N(2, 2)
  mutate_off(0.1389566363436248)
  add_left
  A1(0.6792102999287781, 2.512931565248651, 1.7548894966087267, 2.2424106119020566)
  mutate_off(0.07387993237540717)
}

rule T -> if inclined = False then {
  A2(-0.9404837751482618, 2.345633935240178, 7.854864421678398, 7.988805925448291)
  mutate_off(1.2596656665534844)
  move_front
  add_right
  move_back
  B
  move_ref_N(1, 1)
  mutate_edge(0.7902641706231178)
  add_front
  A2(-0.02565562240266739, 2.7969399430688466, 9.318011125443718, 3.774120824774773)
  move_back
}
