"""The trained numbers of core/voxel/FORMAT.md, block by block as they stand there; a test compares them.

BLOCKS has the text of each block by its name; `volume-classes` has one for each of the eight tables.
"""

BLOCKS = {
    "gap-sizes": """
60 10 11 12 17 12 13 17 22 24 20 15 11 6 4 2
""",
    "volume-ends": """
 53  85 199    28 163 242    50 180 206    83 153 208    43 218 236    91 198 217   110 180 237   122 229 245
134 210 236   151 250 253   151 173 218    21  46 248     8  20  28    15  28  42    18 254 255    44  85 240
 53  95 131    22  71  83    49 252 253    59 241 245    21 254 255   162 203 234   100 123 252    81 237 247
 35 251 252    62 135 230   122 141 251   115 135 252    59 246 252   199 211 231     8 251 253   105 140 250
 69 251 255   116 249 252   166 220 221    75 254 255   130 178 201   146 233 239   164 223 244   158 240 249
189 234 238   183 236 248   188 209 247   189 252 253   200 235 247   209 247 250   206 253 254   216 235 245
223 253 254   222 245 246   229 249 252   232 254 255   240 254 255   241 248 249   228 233 234   245 254 255
240 244 250   249 250 251   250 254 255   252 254 255   253 254 255   132 182 228
""",
    "volume-classes": (
        """
5555777d777ddfhk577d7bfebdbhfjjm57797dbh7bjefjjp7999bdhkb9hkenna
G3Aa377a3d7aaaaaHL5a2hSa4kIaaaaaD3aa3NdaGXXaaaaaCa2a3h9aHhZaaaaa
77ddd99hddhhhkkmddd9hhmm9hhhkqpq7999dhhhdhjkkpmq999hhhkm9hkmmqqa
lziabaaa59kaaaaazj9aaaaaaaaadaaaTiiaXaaa3kkaaaaaakhaaaaaaaaaXaaa
5337aaaaa3aaaaaa03FaaaaaaXaaaaaa3zPaaaaaa9aaaaaaPaadaaaaaaaaaaaa
332daaaaa3aaaaaaGz6aaaaaa9aaaaaaGa0aaaaaaXaaaaaaPaahaaaaaaaaaaaa
""",
        """
AzTcTiTlTiTlTuuuALTlTlsnLllrTusvLLliTllrTlsnTusvTcTlTisrTisrnrsa
T7zaTdLaolAaaaaaLf6agfaahraaaaaau7gau9gawlTaaaaaT98alhYamrYaaaaa
TusrTvsvsvsyvysysvsuuvrqnrvvuvvysvrrrrrrsuvruvvvuyvyuxvyuxvyrxva
5v7a2aaa6l5aaaaa1okaaaaaaaaa4aaa5ySa4aaa6r5aaaaa1ohaaaaaaaaaJaaa
PY0eaaaaaTaaaaaa38PaaaaaaLaaaaaa0gQaaaaaa9aaaaaaFaalaaaaaaaaaaaa
FnBnaaaaauaaaaaaPcPaaaaaaeaaaaaa0gRaaaaaa9aaaaaaBaaoaaaaaaaaaaaa
""",
        """
z6LzzcLcz8LeLlllz8TcLcsjziljiosrz8icziioLcsjiosrz7lfzdnnzdnmYnsa
073aAd8a8oNaaaaa1c3a6j5aSrJaaaaa0Nzag9fa8oNaaaaa2a5a2Y5a4sOaaaaa
TTssTusssrsvuvsvTusuuuvvlvswuvvvlrsqrrsruuvvuvvvTuvtguvxTuvxnwva
lTuadaaaLilaaaaactkaaaaaaaaadaaaouoa9aaacrnaaaaaiphaaaaaaaaa9aaa
P52baaaaazaaaaaa366aaaaaa7aaaaaa0gVaaaaaa9aaaaaaPaaiaaaaaaaaaaaa
Fe2jaaaaagaaaaaa0L6aaaaaabaaaaaa0gMaaaaaa9aaaaaaFaajaaaaaaaaaaaa
""",
        """
aaaYsorruorxywyyffejjkwmrrptytyxccsjeopwqjtoxqxxlkmhsmxmomtmytya
A3aaTzcaaiGaaaaa4TGa4nJa2r2aaaaar3lal5iaeehaaaaa4Laa5nbaNnIaaaaa
eonrotrtrtrtxyyyfootwyyxoxtxxyyyetotqxkyrvwyyxyyoxpkwwytrwxtyyya
GxaabaaaGuaaaaaazrhaaaaaaaaabaaaaylaJaaazteaaaaaarkaaaaaaaaa9aaa
GrGtaaaaaeaaaaaaGeGaaaaaaYaaaaaaGazaaaaaahaaaaaaFaamaaaaaaaaaaaa
0lataaaaafaaaaaaGlAaaaaaahaaaaaa3a3aaaaaabaaaaaaFaamaaaaaaaaaaaa
""",
        """
06gio9no7NeqTmvr3hgifSx99ohplpyy2Nbocobo7Sxkltvy34nf1Sjk2Sohehva
P66aPiXa4uXaaaaa4c4a1tEaOyZaaaaaP1zaP9fa4vcaaaaaG77a1kOaUvZaaaaa
znswywttrqsouwyviorowxyyqwqwyyyyeomqqyryuxyyyyyyiqwqoyyyowxqwwya
itmaoaaaftkaaaaaoymaaaaaaaaataaaujuakaaaghyaaaaafwmaaaaaaaaamaaa
548baaaaa1aaaaaaF2VaaaaaaWaaaaaaPdPaaaaaahaaaaaa7aaXaaaaaaaaaaaa
337maaaaa4aaaaaaGPiaaaaaaZaaaaaaPfVaaaaaa9aaaaaaPaahaaaaaaaaaaaa
""",
        """
eAslxhrwf9YnrkxrAfTuohxmeqeouwyy3Seulcmn7StmlqyyPSlm6NwqaNnqmkya
66caPdXaNu9aaaaaJiSa4mKaZxZaaaaa01gaPWfaeobaaaaa289a19Za5wXaaaaa
cjlmytqqrtrqwtxviotqtxyytxqvyyyyejqoouqwrtyyxyyyiwwwovyyotwtwxya
9rhaeaaadthaaaaaiykaaaaaaaaapaaaTllaZaaaghwaaaaa6qtaaaaaaaaa9aaa
33gjaaaaa4aaaaaa3LVaaaaaaZaaaaaa0cPaaaaaajaaaaaaPaa9aaaaaaaaaaaa
33btaaaaa1aaaaaa3VgaaaaaaZaaaaaaPcVaaaaaaXaaaaaaFaamaaaaaaaaaaaa
""",
        """
Tbseldnredqqtkwsidljo9xmldjmrpxw8dljfjnooXxmrpxweNodi9wpk9wpomya
5zLa7hhaJp7aaaaaOl6aOqZaKtZaaaaa57gacXoa7kdaaaaaOfTaNk9aOq9aaaaa
iorsrtwrrtwtxwywlowqxxyyoxtwyyyyeotooypyttyyxyyyokxmwtyxwqyxwwya
6jqaXaaacumaaaaafxhaaaaaaaaakaaaLtwaZaaaitqaaaaa8wpaaaaaaaaahaaa
0LgmaaaaaNaaaaaa3bVaaaaaa9aaaaaa0f6aaaaaamaaaaaaFaahaaaaaaaaaaaa
FfctaaaaaXaaaaaa0f6aaaaaa9aaaaaa3c6aaaaaa9aaaaaaFaamaaaaaaaaaaaa
""",
        """
PG38555t2N5rAlsrPdFi55sb4iOjAtsv2g2LJnJj25sbTwsy12P725bk245hYnsa
1APa1l1aUT3aaaaa4uUa1xUaUvIaaaaaPz0aPdca4T3aaaaa4lUa1tOaUrmaaaaa
eYefrosenosksysvfij7rxywoxkrxyyyejhojxrxsvywsyvyiktiopxwoTwtwxya
u5xauaaaixqaaaaajyhaaaaaaaaaraaaulyaraaagqyaaaaafymaaaaaaaaamaaa
b4bJaaaaaUaaaaaaP4caaaaaaIaaaaaaPePaaaaaamaaaaaa7aa7aaaaaaaaaaaa
54NNaaaaaNaaaaaa2PdaaaaaaZaaaaaaPfPaaaaaa9aaaaaa6aahaaaaaaaaaaaa
""",
    ),
    "intervals": """
 23  41  65  96 118 143 167 193 209 227 243 246 250 253 252 253
250 253 253 252 254 254 255 255 254 255 255 255 255 255 255 255
  1  10  11  26  44  55  75 121 145 171 194 228 235 245 253 255
""",
    "weights-level-even": """
  41   52   53   40   54   68   55   40   53   54   47   40   40   40   40   40
  46   42   50   64   56   71   79   64   69   88   66   64   64   64   64   64
  -7   13   26    0  -24    5    0    0    8    6  -11    0    0    0    0    0
 -47  -60  -37    0  -54  -35    9    0   -9    6   35    0    0    0    0    0
  -1   -7  -27    0  -12    9   -7    0  -19  -10    0    0    0    0    0    0
  16  -16  -28    0   42   -1  -36    0   28   22  -10    0    0    0    0    0
   7  -16   -9    0   15    0   13    0   -2  -17   12    0    0    0    0    0
 -41  -43  -24    0  -14    0    8    0    1   34   19    0    0    0    0    0
 -20   -4   -2    0    4    3    4    0   -4   -3  -18    0    0    0    0    0
 -54  -17  -23    0  -14    0   16    0    5    5   45    0    0    0    0    0
  11  -16  -22    0   -3    1   -1    0  -16   -5   -2    0    0    0    0    0
 -51  -19   33    0  -47   -6   26    0  -30  -11   -2    0    0    0    0    0
  11    8   31    0   -2   -2  -12    0   -5    0   -8    0    0    0    0    0
  79  116  107    0   21   27   25    0   12  -13  -28    0    0    0    0    0
  19   -3   -1    0   -7    1    2    0   -6    2   -4    0    0    0    0    0
 101  112   74    0    4    0  -13    0  -12    0   15    0    0    0    0    0
 -10    2   15    0    1    2  -14    0  -14    0    8    0    0    0    0    0
 114  100   45    0  -51    2  127    0  -29    0   16    0    0    0    0    0
""",
    "weights-level-odd": """
  41   53   52   40   52   68   53   40   54   55   45   40   40   40   40   40
  30   49   71   64   38   69   86   64   57   78   83   64   64   64   64   64
   3   17   32    0  -28    5    7    0    2    4   -7    0    0    0    0    0
 -79  -81  -37    0  -42  -36    1    0   17   19   46    0    0    0    0    0
  -1  -10  -32    0  -15   11  -11    0  -21  -11    3    0    0    0    0    0
  36  -24  -65    0   42   -3  -44    0   66   37  -18    0    0    0    0    0
  11   -9   -4    0   14   -2   13    0    0  -11   13    0    0    0    0    0
  -1  -15  -11    0    8    1   -3    0   -1   14   -3    0    0    0    0    0
  -5   -3    7    0    7   -4    7    0    4   -3   -5    0    0    0    0    0
  -6   -7  -31    0    8    0  -10    0   15    2    4    0    0    0    0    0
  13  -16  -26    0    3   -1   -2    0  -11   -4   -2    0    0    0    0    0
 -94  -14   52    0  -60    5   48    0  -43  -12    2    0    0    0    0    0
   7   -2   27    0   -1   -1  -19    0   -1    3   -6    0    0    0    0    0
  41   71  111    0    9   36   72    0  -19  -29  -28    0    0    0    0    0
  20   -2   -3    0  -16    4   -3    0  -11    4   -9    0    0    0    0    0
  87   75   53    0    1   -1   -7    0  -36    1   37    0    0    0    0    0
 -14    4   29    0    8    2  -15    0   -6    0    5    0    0    0    0    0
  92   76   28    0  -47   -1  127    0  -25    1    4    0    0    0    0    0
  -3   12   -1    0  -41  -36   15    0   17  -34  -46    0   -2  -30    7    0
  24   -3  -37    0   56   69   32    0  -31  -65  -91    0  -62   -4   64    0
  -1   11   -5    0   15  -34  -39    0  -33  -30   18    0   18  -26    5    0
 -38   -4   31    0   23   63   55    0  -82  -64  -24    0   62  -11  -61    0
   0    1    1    0   -7    6    4    0   22    7    0    0   27  -12  -19    0
  94  -10    4    0   29   -9   32    0   41  -29  -29    0   40  -16    5    0
   0   -1    0    0   -8    3    3    0   23    0   -3    0   28  -17  -22    0
  87    0    0    0   28    7   31    0   34  -18  -37    0   44    2   -7    0
""",
    "weights-carried-even": """
  52   44   49   40   50   53   52   40   50   45   53   40   40   40   40   40
  50   54   71   64   52   64   75   64   50   74   77   64   64   64   64   64
  17   22   17    0   -5   -4   -1    0   -3   -2   -2    0    0    0    0    0
 -27  -22  -26    0   -1  -11   -6    0   14    3    4    0    0    0    0    0
  -1   -5  -23    0  -13   11  -12    0  -21   -2    5    0    0    0    0    0
  16  -19  -24    0   51    1  -45    0   28   18  -15    0    0    0    0    0
   0   -1    0    0   -4    5   -3    0   -3   -4    0    0    0    0    0    0
  25   23   30    0   -7    1    6    0   -7  -21  -24    0    0    0    0    0
  -1   -2    2    0    1    2    2    0    0   -2   -3    0    0    0    0    0
 -27   -4   -5    0  -13    0   11    0    2    8   24    0    0    0    0    0
  11  -32  -29    0   -1    2    0    0  -15   -1    0    0    0    0    0    0
 -18   21   31    0  -32    2   20    0  -32   -8    1    0    0    0    0    0
   4   -5    6    0    3   -1   -6    0    2    0   -1    0    0    0    0    0
  -2   40   89    0   12    0    5    0   19   -5  -27    0    0    0    0    0
  -4   -3    9    0    4   -1   -1    0    1    0   -2    0    0    0    0    0
  19   -2    1    0    5    2   -5    0   -5   -1    6    0    0    0    0    0
   3   -1   -2    0   -1    1   -2    0    1    0   -1    0    0    0    0    0
  23   -1  -20    0  -20    4   21    0  -10    1    4    0    0    0    0    0
""",
    "weights-carried-odd": """
  51   49   53   40   49   53   51   40   49   51   53   40   40   40   40   40
  54   65   62   64   53   66   71   64   63   69   71   64   64   64   64   64
  13   20   13    0   -4   -4    0    0   -2   -1   -1    0    0    0    0    0
   4  -20  -35    0  -10   -7   -3    0    8    3    9    0    0    0    0    0
  -2   -4  -23    0  -13   11  -12    0  -19   -2    2    0    0    0    0    0
  16  -22  -17    0   39    1  -34    0   17   22  -14    0    0    0    0    0
   0   -2    1    0    1    4    1    0   -1   -4   -1    0    0    0    0    0
  20   18   18    0    7   -1   -3    0  -11  -18  -18    0    0    0    0    0
   0   -2    4    0    1   -1    3    0    0   -3    0    0    0    0    0    0
 -32   -9   -6    0  -15    0   11    0    3   10   30    0    0    0    0    0
  11  -29  -27    0   -6    2    2    0  -19   -1    0    0    0    0    0    0
 -18   20   25    0  -28    5   19    0  -25   -5    1    0    0    0    0    0
   5   -3    8    0    1   -1   -8    0    1    1   -1    0    0    0    0    0
   2   27   77    0   12   -5    4    0   16   -3  -26    0    0    0    0    0
  -4   -1    6    0    1    0   -1    0    1    1   -4    0    0    0    0    0
   6    2    8    0    5    3   -6    0   -3   -1    4    0    0    0    0    0
   3   -2   -1    0   -2    1   -1    0    0    0   -1    0    0    0    0    0
  14    0  -15    0  -16    1   30    0   -3    0   -1    0    0    0    0    0
   3    5    4    0    9   -9  -13    0  -14   -9    8    0   -7  -15   -5    0
  -1    0    3    0  -19  -25  -17    0   20   24   19    0    3   -2   -1    0
   3    2    4    0   -3   -6   -6    0   -6   -7   -4    0    1   -5   -3    0
   4    0   -5    0  -10  -14  -18    0   16   16   12    0  -12    4    7    0
  -1   -2    0    0  -15    8    1    0   -6    5    0    0   -2    4    0    0
   8   -1   -1    0    2    0   -8    0  -20    0    8    0  -40   12    4    0
   0   -2    0    0  -11    5    0    0    1    0    0    0    4    5   -4    0
  -3    0    1    0   21    8   -7    0    0   -2    4    0   13  -22    4    0
""",
    "weights-first-even": """
  40   40   40   40   40   61   40   40   40   40   40   40   40   40   40   40
  64   64   64   64   64   66   64   64   64   64   64   64   64   64   64   64
   0    4    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0  -19    0  -28    5  -30    0  -26   -1   -3    0    0    0    0    0
  18  -20  -38    0   42    1  -43    0   23   26  -30    0    0    0    0    0
   0    0    0    0    0    2    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    2    0    0    0    0    0    0    0    0    0
   0    0    0    0  -15    1   16    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   5   -2    4    0    0    0    0    0    0    0    0    0    0    0    0    0
  23    0  -24    0    0    0    0    0    0    0    0    0    0    0    0    0
  -2    1   -4    0    0    0    0    0    0    0    0    0    0    0    0    0
   9   -1   -6    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
""",
    "weights-first-odd": """
  40   40   40   40   40   63   40   40   40   40   40   40   40   40   40   40
  64   64   64   64   64   64   64   64   64   64   64   64   64   64   64   64
   0    5    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
 -10    1  -25    0  -33    7  -33    0  -32    5  -15    0    0    0    0    0
  27  -23  -33    0   43    0  -40    0   20   23  -23    0    0    0    0    0
   0    0    0    0    0    3    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    3   -1    3    0    0    0    0    0    0    0    0    0
   0    0    0    0  -17    0   19    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   4   -2    3    0    0    0    0    0    0    0    0    0    0    0    0    0
  23    0  -22    0    0    0    0    0    0    0    0    0    0    0    0    0
  -4    1   -5    0    0    0    0    0    0    0    0    0    0    0    0    0
   7    0  -10    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   0    0    0    0    0    0    0    0    0    0    0    0    0    0    0    0
   6    4    8    0  -16  -19  -40    0  -30  -22   -5    0  -23  -20  -25    0
  12    1   -2    0  -17   -3  -24    0    9   -1   -4    0   -2   -3  -11    0
  11    4   17    0   -6  -10   -1    0  -30  -14  -14    0  -21  -37  -22    0
  -5    0  -11    0   -6   15  -10    0   26  -12   13    0   52   -1  -45    0
  -2    0    0    0    5    0    0    0    6    0    0    0    6    0    0    0
   0    0    0    0   -2    0    0    0    2    0    0    0    0    0    0    0
   0    0    0    0   -1    0    0    0    0    0    0    0   -5    0    0    0
   0    0    0    0    1    0    0    0    0    0    0    0    0    0    0    0
""",
}
