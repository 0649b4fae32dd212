plsc 1  # expect warning[W3005]
alphabet plasticoding 1
sense a: bool sense b: bool sense c: bool sense d: bool sense e: bool
sense f: bool sense g: bool sense h: bool sense i: bool sense j: bool
sense k: bool sense l: bool sense m: bool sense n: bool sense o: bool
sense p: bool sense q: bool
rule C -> if a = True and b = True and c = True and d = True and e = True and  # expect warning[W3005]
  f = True and g = True and h = True and i = True and j = True and k = True and
  l = True and m = True and n = True and o = True and p = True and q = True
then { C }
